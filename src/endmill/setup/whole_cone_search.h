// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>

#include "endmill/machine/rotary_limits.h"
#include "endmill/setup/setup_objective.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// How far a search has come.
struct SetSearchProgress {
    std::size_t nodes;                ///< bounded
    std::optional<double> objective;  ///< of the best pose so far, as in SetSearchResult
    double lower_bound;               ///< no pose has less; the same
};

/// What to search for, and how long.
struct SetSearchOptions {
    RotaryFamily family = RotaryFamily::CA;
    SetupObjective objective = SetupObjective::FlooredArea;
    double floor_rad = 5.9 * std::numbers::pi / 180;  ///< of FlooredArea: a cell of 1200
    double gap = 0.05;  ///< stop where objective <= (1 + gap) lower bound, or below 1e-9
    std::size_t max_nodes = 200'000;    ///< triangles of axes to bound, then stop
    RotaryLimits limits;                ///< turns of the tool, words with R2 = C x R1
    std::span<const SetupPose> starts;  ///< poses whose axes are tried first
    /// Called now and then by the calling thread. What it throws ends the work.
    std::function<void(const SetSearchProgress&)> progress = {};
};

/// Whether one setup does.
enum class Machinability : std::uint8_t {
    Machinable,  ///< a pose is given
    Impossible,  ///< proved: no pose within the limits reaches everything
    Undecided    ///< none was found, and none is excluded
};

/// What the search knows at its end.
struct SetSearchResult {
    Machinability machinability = Machinability::Undecided;
    std::optional<FittedPose> pose;  ///< the best one found, if machinable
    PoseRanges ranges;               ///< of that pose: w, m0, m1
    double objective = 0;            ///< of that pose, rad^2 for FlooredArea, else rad
    double lower_bound = 0;          ///< no pose within the limits has less; rounded down
    std::size_t nodes = 0;           ///< bounded
    std::size_t unresolved = 0;      ///< too small to split, and not excluded
};

/// The pose whose range of tool directions meets all visibility cones with the least objective:
/// branch and bound over the axis that all directions are seen from (C in C,A, R1 in A,B), a
/// cone being the centres of its accessible cells. The window of the first axis may lie
/// anywhere about it. Empty cones do not count: report them. Without any other cone every pose
/// does, and all ranges are 0. The same for any number of threads. A range may pass its limit
/// by 1e-9 rad. The bound is derived in paper/notes/whole-cones.md.
/// \throws DomainError unless map and grid have the same cells, floor_rad > 0 and gap > 0.
SetSearchResult set_search(const SphereGrid& grid, const VisibilityMap& map,
                           const SetSearchOptions& options);

}  // namespace endmill
