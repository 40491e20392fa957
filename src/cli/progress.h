// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "cli/command.h"

namespace endmill {

/// A line on standard error that tells how far long work has come: after the first
/// second, if standard error is a terminal, and not with --quiet.
class ProgressLine {
public:
    /// \param work what is done, as the line names it; it begins now.
    ProgressLine(std::string work, const CommonOptions& options);
    ~ProgressLine();                                        ///< wipes the line
    ProgressLine(const ProgressLine&) = delete;             ///< one line, one owner
    ProgressLine& operator=(const ProgressLine&) = delete;  ///< ditto

    /// \param share done so far, 0 to 1.
    void show(double share);

    /// \param text how far the work is, where nobody knows how much is left.
    void show(const std::string& text);

private:
    using Clock = std::chrono::steady_clock;

    std::string work_;
    bool is_wanted_;
    bool is_shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_ + std::chrono::seconds{1};
};

}  // namespace endmill
