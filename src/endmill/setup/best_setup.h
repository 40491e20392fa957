// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string_view>

#include "endmill/setup/setup_mode.h"
#include "endmill/setup/setup_objective.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/setup/whole_cone_search.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// What is asked of a setup, whatever the method.
struct SetupRequest {
    RotaryFamily family = RotaryFamily::CA;
    bool is_b_first = false;  ///< A,B: the first rotary axis is B
    /// How it is found; none: over whole cones, by `set_search`.
    std::optional<SetupMode> mode = SetupMode::Paper;
    RotaryLimits limits = {};
    /// Of the search over whole cones; the others minimise the area.
    SetupObjective objective = SetupObjective::FlooredArea;
    double floor = 5.9 * std::numbers::pi / 180;  ///< rad, of the floored area: above 0
    double gap = 0.05;                ///< of the search over whole cones: above 0
    std::size_t max_nodes = 200'000;  ///< the same
    /// Of the search at cells, as in SetupOptions: two looks at each.
    std::function<void(std::size_t looks)> cell_progress = {};
    /// Of the search over whole cones, as in SetSearchOptions.
    std::function<void(const SetSearchProgress&)> set_progress = {};
};

/// The best setup, and what is known of it.
struct BestSetup {
    /// None: undecided. A search over poses at cells decides for these alone; see `is_proved`.
    std::optional<bool> is_machinable;
    bool is_proved = false;  ///< machinable, or excluded for every pose
    SetupStatus status = SetupStatus::Ok;
    std::optional<FittedPose> feasible;  ///< the best within the limits
    std::optional<FittedPose> least;     ///< whatever the limits: MAR
    std::size_t poses_tried = 0;         ///< of the search over whole cones: nodes
    std::size_t poses_skipped = 0;       ///< directions not in an open hemisphere
    std::size_t unresolved = 0;          ///< nodes too small to split, not excluded
    /// What was minimised, of the best within the limits, or if there is none of the least;
    /// rad^2, or rad for objectives in degrees.
    std::optional<double> objective;
    std::optional<double> lower_bound;  ///< certified; the search over whole cones alone
};

/// The ranges of a pose as objectives take them.
PoseRanges pose_ranges(RotaryFamily family, const FittedPose& fit);

/// [S, L], the smaller and the larger magnitude of a range's ends, in rad.
/// Source: [KangSuh, eq. (10), (19)].
std::array<double, 2> magnitudes(const RotaryRange& range);

/// The best setup for the cones of `map`, empty ones left out. The search over whole cones
/// starts from the poses of `SetupMode::Corrected`, so that it is never worse.
/// Source: [KangSuh, sections 4 to 6].
/// \throws DomainError as `setup_search` and `set_search`.
BestSetup best_setup(const SphereGrid& grid, const VisibilityMap& map,
                     const SetupRequest& request);

}  // namespace endmill
