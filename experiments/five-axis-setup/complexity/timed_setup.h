// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/studied_part.h"

namespace endmill {

/// A timed step of the search for a setup.
struct SetupWork {
    std::string name;
    std::function<void(const StudiedPart&)> run;  ///< on a part with its map
};

/// Visibility at an incidence of 90 degrees; the search in the modes `paper` (both
/// families) and `corrected` (A,B); the search over whole cones in A,B to a gap of 5 %.
std::vector<SetupWork> setup_works();

/// CPU time in s of `work` on one thread, the best within `budget_s`, see cpu_time.h.
double work_s(const SetupWork& work, const StudiedPart& part, double budget_s);

}  // namespace endmill
