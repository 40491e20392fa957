// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

namespace endmill {
namespace {

constexpr std::chrono::milliseconds redraw_interval{200};
constexpr std::chrono::seconds quiet_time{1};

// The time counts from the start of the program, since several short phases add up.
const auto program_start = std::chrono::steady_clock::now();

}  // namespace

ProgressLine::ProgressLine(std::string work, const CommonOptions& options)
    : work_{std::move(work)}
{
    if (!options.quiet && isatty(STDERR_FILENO) == 1)
        thread_ = std::thread{[this] { run(); }};
}

ProgressLine::~ProgressLine()
{
    if (!thread_.joinable())
        return;
    {
        const std::lock_guard lock{mutex_};
        is_over_ = true;
    }
    is_over_changed_.notify_one();
    thread_.join();
    if (is_shown_)
        std::fputs("\r\033[K", stderr);
}

void ProgressLine::begin(std::string work)
{
    const std::lock_guard lock{mutex_};
    work_ = std::move(work);
    state_.clear();
}

void ProgressLine::show(double share)
{
    show(fmt::format("{:.0f} %", 100 * share));
}

void ProgressLine::show(std::string state)
{
    const std::lock_guard lock{mutex_};
    state_ = std::move(state);
}

void ProgressLine::run()
{
    std::unique_lock lock{mutex_};
    const auto is_over = [this] { return is_over_; };
    if (is_over_changed_.wait_until(lock, program_start + quiet_time, is_over))
        return;
    do
        draw();
    while (!is_over_changed_.wait_for(lock, redraw_interval, is_over));
}

void ProgressLine::draw()
{
    is_shown_ = true;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - program_start)
            .count();
    std::fprintf(stderr, "\r\033[K%s: %s%s%.0f s", work_.c_str(), state_.c_str(),
                 state_.empty() ? "" : ", ", seconds);
    std::fflush(stderr);
}

}  // namespace endmill
