// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/studied_part.h"

namespace endmill {

/// A step on the way to a setup that is timed.
struct SetupWork {
    std::string name;
    std::function<void(const StudiedPart&)> run;  ///< on a part whose map is there
};

/// Visibility at an incidence of 90 degrees, the search in the modes `paper` of both families
/// and `corrected` of A,B, and that over whole cones in A,B to a gap of 5 %.
std::vector<SetupWork> setup_works();

/// CPU time in s of `work` on one thread, the best within `budget_s`, see cpu_time.h.
double work_s(const SetupWork& work, const StudiedPart& part, double budget_s);

}  // namespace endmill
