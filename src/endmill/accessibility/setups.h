// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/accessibility/setup_pose.h"
#include "endmill/accessibility/setup_reach.h"
#include "endmill/accessibility/visibility_map.h"
#include "endmill/core/vec.h"

namespace endmill {

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

/// How far a greedy choice has come.
struct SetupsProgress {
    std::size_t setup;  ///< number of the one that is looked for, from 1
    std::size_t tried;  ///< tool axes tried for it
    std::size_t axes;   ///< of so many; the rest may turn out not to be worth a trial
};

/// The setups of a greedy choice, at most `most`: always the one that reaches most of the rest.
/// Candidates have the centre of a cell for tool axis and the other axes turned by steps of 5
/// degrees about it; a facet is reached if the feasible directions hold a cell of its cone. Of
/// equal ones the lowest cell counts, then the least turn. Greedy is not optimal. Empty cones
/// are left out. The same for any number of threads.
///
/// Facets with equal cones count as one; a candidate reaches no more of a rest than it did of an
/// earlier one, so that after the first setup few are tried again. The first costs about
/// cells^2 (72 + facets / 16) operations, the memory is twice that of the map.
/// Source: [KangSuh, section 1], who name the fewest setups and leave them to others.
/// \param centres unit, one for each cell. \throws DomainError unless they are, and 3 <= axes
///        <= 5, 1 <= most.
/// \param progress called now and then by the calling thread; what it throws ends the work.
SetupCover greedy_setups(const VisibilityMap& map, std::span<const Vec3> centres,
                         const SetupReach& reach, std::size_t most,
                         const std::function<void(const SetupsProgress&)>& progress = {});

}  // namespace endmill
