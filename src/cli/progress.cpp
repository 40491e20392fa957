// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

namespace endmill {
namespace {

constexpr std::chrono::milliseconds redraw_interval{200};
constexpr std::chrono::milliseconds object_interval{500};  // of --json-progress
constexpr std::chrono::seconds quiet_time{1};
constexpr std::chrono::seconds line_interval{10};  // where there is no terminal

// An estimate of the time left needs this share and this time of the work: earlier ones
// depend on how the work starts.
constexpr double least_share = 0.02;
constexpr double least_seconds = 1;
// Where there is no terminal, the first line comes early if this much time is left. A rough
// estimate is enough for it.
constexpr std::chrono::milliseconds early_check_interval{250};
constexpr double long_wait_seconds = 10;

constexpr double s_per_min = 60;
constexpr long min_per_h = 60;

// The time counts from the start of the program, since several short phases add up.
const auto program_start = std::chrono::steady_clock::now();

double elapsed_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();
}

// The next whole multiple of `line_interval` after the start of the program. Phases that
// follow each other then share one clock.
std::chrono::steady_clock::time_point next_line_time()
{
    const auto lines =
        (std::chrono::steady_clock::now() - program_start) / line_interval + 1;
    return program_start + lines * line_interval;
}

bool is_terminal()
{
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace

std::string waiting_time(double seconds)
{
    if (seconds < s_per_min)
        return fmt::format("{:.0f} s", std::ceil(seconds));
    const long minutes = std::lround(seconds / s_per_min);
    if (minutes < min_per_h)
        return fmt::format("{} min", minutes);
    return fmt::format("{} h {} min", minutes / min_per_h, minutes % min_per_h);
}

ProgressLine::ProgressLine(std::string work, const CommonOptions& options, double later)
    : is_json_{options.json_progress},
      work_{std::move(work)},
      later_{later}
{
    if (options.quiet)
        return;
    try {
        thread_ = std::thread{[this] { show_until_over(); }};
    } catch (const std::exception&) {
        return;  // no thread to be had: the work goes on without progress
    }
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

void ProgressLine::begin(std::string work, double later)
{
    const std::lock_guard lock{mutex_};
    if (work == work_)
        return;
    work_ = std::move(work);
    later_ = later;
    work_start_ = Clock::now();
    state_.clear();
    share_ = 0;
    has_line_ = false;
}

void ProgressLine::show(double share)
{
    show(fmt::format("{:.0f} %", 100 * share), share);
}

void ProgressLine::show(std::string state)
{
    show(std::move(state), 0);
}

void ProgressLine::show(std::string state, double share)
{
    const std::lock_guard lock{mutex_};
    state_ = std::move(state);
    share_ = share;
}

void ProgressLine::show_until_over()
{
    try {
        run();
    } catch (const std::exception&) {
        return;  // no memory for a line
    }
}

void ProgressLine::run()
{
    std::unique_lock lock{mutex_};
    const auto is_over = [this] { return is_over_; };
    next_line_ = next_line_time();
    if (is_json_) {
        while (!is_over_changed_.wait_for(lock, object_interval, is_over))
            print_object();
        return;
    }
    if (!is_terminal()) {
        while (!is_over_changed_.wait_until(lock, next_check_time(), is_over))
            if (Clock::now() >= next_line_ || is_early_line_due())
                print_line();
        return;
    }
    if (is_over_changed_.wait_until(lock, program_start + quiet_time, is_over))
        return;
    do
        draw();
    while (!is_over_changed_.wait_for(lock, redraw_interval, is_over));
}

// Each work has one early line at most.
std::chrono::steady_clock::time_point ProgressLine::next_check_time() const
{
    return has_line_ ? next_line_
                     : std::min(next_line_, Clock::now() + early_check_interval);
}

bool ProgressLine::is_early_line_due() const
{
    if (has_line_ || !(share_ > 0) || Clock::now() < program_start + quiet_time)
        return false;
    return seconds_left() >= long_wait_seconds;
}

// \pre The share is known.
double ProgressLine::seconds_left() const
{
    return elapsed_since(work_start_) * (1 - share_ + later_) / share_;
}

bool ProgressLine::has_estimate() const
{
    return share_ >= least_share && elapsed_since(work_start_) >= least_seconds &&
           (share_ < 1 || later_ > 0);
}

std::string ProgressLine::text(Estimate estimate) const
{
    std::string text =
        fmt::format("{}: {}{}{:.0f} s", work_, state_, state_.empty() ? "" : ", ",
                    elapsed_since(program_start));
    const bool has_rest = share_ > 0 && (share_ < 1 || later_ > 0);
    if (has_rest && (has_estimate() || estimate == Estimate::Rough))
        text += fmt::format(", about {} left", waiting_time(seconds_left()));
    return text;
}

void ProgressLine::draw()
{
    is_shown_ = true;
    std::fprintf(stderr, "\r\033[K%s", text(Estimate::Sound).c_str());
    std::fflush(stderr);
}

void ProgressLine::print_line()
{
    std::fprintf(stderr, "endmill: %s\n", text(Estimate::Rough).c_str());
    std::fflush(stderr);
    has_line_ = true;
    next_line_ = next_line_time();
}

void ProgressLine::print_object() const
{
    const Json progress{
        {"work", work_},
        {"state", state_.empty() ? Json(nullptr) : Json(state_)},
        {"share", share_ > 0 ? Json(share_) : Json(nullptr)},
        {"elapsed_s", elapsed_since(program_start)},
        {"left_s", has_estimate() ? Json(seconds_left()) : Json(nullptr)}};
    const Json object{{"progress", progress}};
    std::fprintf(stderr, "%s\n",
                 object.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    std::fflush(stderr);
}

}  // namespace endmill
