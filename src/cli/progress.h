// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/command.h"

namespace endmill {

/// A line on standard error that names the work in progress, how far it is and the time
/// since the program began. It appears once the program has run for a second, if standard error is a
/// terminal, and not with --quiet. A thread of its own keeps the time up to date, so that
/// work that reports nothing is seen to go on. Any thread may report.
///
/// At most one line exists at a time, and nothing else is printed while it does.
class ProgressLine {
public:
    /// \param work name of the work, such as "slicing"; it begins now.
    ProgressLine(std::string work, const CommonOptions& options);
    ~ProgressLine();                                        ///< removes the line
    ProgressLine(const ProgressLine&) = delete;             ///< one line, one owner
    ProgressLine& operator=(const ProgressLine&) = delete;  ///< ditto

    /// Names the work that follows; nothing is known of its share yet.
    void begin(std::string work);

    /// \param share done so far, 0 to 1.
    void show(double share);

    /// \param state how far the work is, where its end is not known.
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
