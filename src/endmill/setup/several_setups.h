// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Several setups that together reach the facets of a part.

namespace endmill {

/// One of several setups.
struct PartialSetup {
    SetupPose pose;                   ///< axes in coordinates of the part
    std::vector<std::size_t> facets;  ///< facets that no earlier setup reaches; ascending
};

/// Setups chosen one after the other.
struct SetupCover {
    std::vector<PartialSetup> setups;    ///< in the order of their choice
    std::vector<std::size_t> uncovered;  ///< facets with a cone, but reached by no setup
};

/// Progress of a choice of setups.
struct SetupCoverProgress {
    std::size_t setup;  ///< number of the setup that is searched for, from 1
    std::size_t tried;  ///< tool axes tried for it
    std::size_t axes;   ///< number of all tool axes; not all of them are tried
};

/// Chooses setups greedily: each setup reaches as many of the remaining facets as
/// possible.
///
/// A candidate has the centre of a cell as its tool axis, and the other axes turned about
/// it by a multiple of 5 degrees. It reaches a facet if its tool directions contain a
/// cell of the facet's cone. Among equal candidates the one with the lowest cell wins,
/// then the one with the least angle. The greedy choice is not optimal. Facets with empty
/// cones are left out. The result does not depend on the number of threads.
///
/// The first setup costs about cells^2 (72 + facets / 16) operations. Later setups try
/// few tool axes, because the number of remaining facets that a candidate reaches never
/// increases. Memory: twice that of the map.
/// Source: [KangSuh, section 1], which names the fewest setups as a goal;
/// docs/methods/five-axis-setup.md, section 10.
/// \param map cones of the facets. \param centres unit, one for each cell.
/// \param reach the machine. \param most largest number of setups, at least 1.
/// \param progress if set, it is called with the state of the search, by the calling
///         thread. An exception ends the search.
/// \throws DomainError if there is not one centre for each cell, if the configuration is
///         not valid, or unless 1 <= most.
SetupCover greedy_setups(
    const VisibilityMap& map, std::span<const Vec3> centres, const RotaryReach& reach,
    std::size_t most,
    const std::function<void(const SetupCoverProgress&)>& progress = {});

}  // namespace endmill
