// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/command.h"

namespace endmill {

/// A progress line on standard error. It shows the current work, the share that is done
/// and the time since the program began. The line appears after the program has run for
/// one second, only if standard error is a terminal, and not with --quiet. A separate
/// thread updates the time, so the line changes even if the work reports nothing. Any
/// thread may report progress.
///
/// At most one line exists at a time. Nothing else is printed while it exists.
class ProgressLine {
public:
    /// \param work name of the work, such as "slicing"; it begins now.
    ProgressLine(std::string work, const CommonOptions& options);
    ~ProgressLine();                                        ///< removes the line
    ProgressLine(const ProgressLine&) = delete;             ///< one line, one owner
    ProgressLine& operator=(const ProgressLine&) = delete;  ///< not assignable either

    /// Starts new work, whose share is not known yet.
    void begin(std::string work);

    /// \param share of the work that is done, 0 to 1.
    void show(double share);

    /// \param state progress in words, for work whose end is not known.
    void show(std::string state);

private:
    void run();
    void draw();

    std::mutex mutex_;
    std::condition_variable is_over_changed_;
    bool is_over_ = false;
    bool is_shown_ = false;
    std::string work_;
    std::string state_;
    std::thread thread_;
};

}  // namespace endmill
