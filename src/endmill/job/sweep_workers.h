// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "endmill/job/ranks.h"

namespace endmill {

/// The other ranks as workers of a sweep, seen from rank 0. A worker sends what it has, first
/// nothing, and waits for a case or for the end of the work: each message has one answer.
class SweepWorkers {
public:
    /// \pre This is rank 0, and all other ranks run `serve_sweep`. `ranks` outlives this.
    explicit SweepWorkers(Ranks& ranks);
    ~SweepWorkers();  ///< waits for the cases that are running, and ends all workers
    SweepWorkers(const SweepWorkers&) = delete;             ///< it owes each an answer
    SweepWorkers& operator=(const SweepWorkers&) = delete;  ///< not assignable either

    bool is_open() const { return open_ > 0; }  ///< whether a worker has not been ended

    /// Waits for the message of a worker. \pre is_open()
    RankMessage next();

    /// Answers the last message of a worker. \param content not empty.
    void give(int worker, std::string_view content);

    /// Answers the last message of a worker by the end of its work.
    void end(int worker);

private:
    Ranks& ranks_;
    int open_;
};

}  // namespace endmill
