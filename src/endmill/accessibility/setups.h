// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/accessibility/setup_pose.h"
#include "endmill/accessibility/visibility_map.h"
#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// What a machine reaches from one setup.
struct SetupReach {
    int axes = 5;                                ///< 3, 4 or 5
    RotaryFamily family = RotaryFamily::CA;      ///< of five axes
    bool is_b_first = false;                     ///< A,B: the first rotary axis is B
    RotaryLimits limits = {};                    ///< of four axes: phi alone
    Angle arc_tolerance = Angle::degrees(2.95);  ///< of four axes: so near a cell counts
};

/// One of several setups.
struct PartialSetup {
    SetupPose pose;
    std::vector<std::size_t> facets;  ///< that it reaches and none before it does; rising
};

/// Setups that together reach as much as was found.
struct SetupCover {
    std::vector<PartialSetup> setups;
    std::vector<std::size_t> uncovered;  ///< facets with a cone that none of them reaches
};

/// The setups of a greedy choice, at most `most`: always the one that reaches most of the rest.
/// Candidates have the centre of a cell for tool axis and the other axes turned by steps of 5
/// degrees about it; a facet is reached if the feasible directions hold a cell of its cone. Of
/// equal ones the lowest cell counts, then the least turn. Greedy is not optimal. Empty cones
/// are left out. O(cells^2 (72 + facets) a setup); the same for any number of threads.
/// Source: [KangSuh, section 1], who name the fewest setups and leave them to others.
/// \param centres unit, one for each cell. \throws DomainError unless they are, and 3 <= axes
///        <= 5, 1 <= most.
SetupCover greedy_setups(const VisibilityMap& map, std::span<const Vec3> centres,
                         const SetupReach& reach, std::size_t most);

}  // namespace endmill
