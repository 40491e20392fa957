// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

namespace endmill {

ProgressLine::ProgressLine(std::string work, const CommonOptions& options)
    : work_{std::move(work)},
      is_wanted_{!options.quiet && isatty(STDERR_FILENO) == 1}
{
}

ProgressLine::~ProgressLine()
{
    if (is_shown_)
        std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double share)
{
    show(fmt::format("{:.0f} %", 100 * share));
}

void ProgressLine::show(const std::string& text)
{
    const auto now = Clock::now();
    if (!is_wanted_ || now < next_)
        return;
    next_ = now + std::chrono::milliseconds{200};
    is_shown_ = true;
    std::fprintf(stderr, "\r\033[K%s: %s", work_.c_str(), text.c_str());
    std::fflush(stderr);
}

}  // namespace endmill
