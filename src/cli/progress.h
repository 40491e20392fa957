// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "cli/command.h"

namespace endmill {

/// Progress on standard error: the current work, the share that is done, the time since
/// the program began, and the time that is left. On a terminal it is one line, which
/// appears after one second and is removed at the end. Elsewhere a line is printed every
/// ten seconds, and one after a second when work seems to need more than ten. With
/// --json-progress a line with a JSON object is printed every half second: its key `progress`
/// has the keys `work`, `state`, `share`, `elapsed_s` and `left_s`; an unknown one is null. With --quiet there is no
/// progress. A separate thread updates the time, so it changes even if the work reports
/// nothing. If the system has no thread or no memory for it, there is no progress. Any thread
/// may report progress.
///
/// The time left follows from the share of the current work and the time that it took. It
/// includes work that follows, if its size is stated. It is omitted while the share is not
/// known, and on a terminal also while the share is too small for a sound estimate.
///
/// At most one line exists at a time. Nothing else is printed while it exists.
class ProgressLine {
public:
    /// \param work name of the work, such as "slicing"; it begins now.
    /// \param later the work that follows, as a multiple of this work; 0: not known.
    ProgressLine(std::string work, const CommonOptions& options, double later = 0);
    ~ProgressLine();                                        ///< removes the line
    ProgressLine(const ProgressLine&) = delete;             ///< one line, one owner
    ProgressLine& operator=(const ProgressLine&) = delete;  ///< not assignable either

    /// Starts new work, whose share is not known yet. Work of the same name goes on.
    /// \param later the work that follows, as a multiple of this work; 0: not known.
    void begin(std::string work, double later = 0);

    /// A callback that shows the share that it receives. This line must outlive it.
    std::function<void(double share)> shower()
    {
        return [this](double share) { show(share); };
    }

    /// \param share of the work that is done, 0 to 1.
    void show(double share);

    /// \param state progress in words, for work whose end is not known.
    void show(std::string state);

    /// \param state progress in words. \param share of the work that is done, 0 to 1.
    void show(std::string state, double share);

private:
    using Clock = std::chrono::steady_clock;

    void show_until_over();
    void run();
    void draw();
    void print_line();
    void print_object() const;
    enum class Estimate { Sound, Rough };  // of the time left
    std::string text(Estimate estimate) const;
    bool has_estimate() const;
    double seconds_left() const;
    Clock::time_point next_check_time() const;
    bool is_early_line_due() const;

    std::mutex mutex_;
    std::condition_variable is_over_changed_;
    bool is_over_ = false;
    bool is_json_;  // an object for programs in place of a line
    bool is_shown_ = false;
    std::string work_;
    Clock::time_point work_start_ = Clock::now();
    std::string state_;
    double share_ = 0;  // of the current work; 0: not known
    double later_ = 0;  // work that follows, as a multiple of the current one
    // Where there is no terminal:
    bool has_line_ = false;  // of the current work
    Clock::time_point next_line_ = Clock::now();
    std::thread thread_;
};

/// A time to wait, for a progress line: "45 s", "3 min", "2 h 10 min". Seconds are rounded
/// up, and longer times to minutes.
std::string waiting_time(double seconds);

}  // namespace endmill
