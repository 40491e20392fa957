// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>

#include "endmill/core/answer.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

/// \file
/// The search over whole cones: it takes every cell of every cone and every pose into
/// account, and proves a lower bound of the objective.
///
/// Implemented in `detail/many_cones_search.cpp`.

namespace endmill {

/// Progress of a search over whole cones.
struct WholeConeSearchProgress {
    std::size_t nodes;                ///< nodes bounded so far
    std::optional<double> objective;  ///< of the best pose so far; rad^2 or rad
    double lower_bound;               ///< no pose has a smaller objective
};

/// Options of a search over whole cones.
struct WholeConeSearchOptions {
    RotaryFamily family = RotaryFamily::CA;                  ///< of the machine
    SetupObjective objective = SetupObjective::FlooredArea;  ///< the minimised quantity
    /// Floor of FlooredArea, above 0. The default is the size of a cell of 1200.
    double floor_rad = 5.9 * std::numbers::pi / 180;

    /// Relative gap at which the search stops: objective <= (1 + gap) * lower bound. It
    /// also stops if the objective is below 1e-9.
    double gap = 0.05;
    std::size_t max_nodes = 200'000;    ///< the search stops after this many nodes
    RotaryLimits limits;                ///< of the rotations, for words with R2 = C x R1
    std::span<const SetupPose> starts;  ///< poses whose axes are tried first

    /// If set, it is called with the state of the search, by the calling thread. An
    /// exception ends the search.
    std::function<void(const WholeConeSearchProgress&)> progress = {};
};

/// Result of a search over whole cones.
struct WholeConeSearchResult {
    /// Whether a pose within the limits meets all cones. `No` is proved.
    Answer machinable = Answer::Undecided;
    std::optional<FittedPose> pose;  ///< the best pose found, set if machinable
    PoseRanges ranges;               ///< w, m0 and m1 of that pose
    double objective = 0;            ///< of that pose; rad^2 for FlooredArea, else rad
    double lower_bound = 0;          ///< of all poses within the limits; rounded down
    std::size_t nodes = 0;           ///< nodes bounded
    /// Number of nodes that are too small to split and that no bound excludes.
    std::size_t unresolved = 0;
};

/// Finds the pose whose range of tool directions meets all visibility cones with the
/// least objective, by branch and bound over the axis of that range (C in C,A, R1 in
/// A,B).
///
/// A cone is the set of the centres of its accessible cells. Empty cones are left out;
/// without any other cone every pose fits and all ranges are 0. Ranges may exceed their
/// limits by 1e-9 rad. The result does not depend on the number of threads.
/// Source: paper/notes/whole-cones.md, section 8; docs/methods/five-axis-setup.md,
/// section 10.
/// \param grid cells. \param map cones of the facets over these cells.
/// \param options what is minimised, and when the search stops.
/// \throws DomainError if map and grid have different numbers of cells, or unless
///         floor_rad > 0 and gap > 0.
WholeConeSearchResult whole_cone_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options);

}  // namespace endmill
