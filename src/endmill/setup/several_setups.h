// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/rotary_angles.h"
#include "endmill/machine/rotary_limits.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// What a machine reaches from one setup.
struct SetupReach {
    int axes = 5;                                ///< 3, 4 or 5
    RotaryFamily family = RotaryFamily::CA;      ///< of five axes
    bool is_b_first = false;                     ///< A,B: the first rotary axis is B
    RotaryLimits limits = {};                    ///< of four axes: phi alone
    Angle arc_tolerance = Angle::degrees(2.95);  ///< of four axes: so near a cell counts
};

/// Ways of turning a part about its tool axis that are tried: steps of 5 degrees.
inline constexpr std::size_t turns_about_tool_axis = 72;

/// The machine's axes with a cell's centre for tool axis, after that many steps about it. Four
/// axes are R1 of A,B, with R2 at rest. \param tool_axis unit.
RotaryFrame frame_at(const SetupReach& reach, const Vec3& tool_axis, std::size_t turn);

/// The turns `first`, `first` + 1 ... about the tool axis, `count` of them, the first again
/// after the last, from which a cell is within the machine's reach.
struct FeasibleTurns {
    std::uint32_t cell;
    std::uint8_t first;
    std::uint8_t count;  ///< 1 to `turns_about_tool_axis`

    /// Whether they hold `turn`.
    bool hold(std::size_t turn) const
    {
        return (turn + turns_about_tool_axis - first) % turns_about_tool_axis < count;
    }
};

/// From which turns about the tool axis, the centre of cell `pole`, which cells are within the
/// limits, to 1e-9 rad; a cell may have several runs of them, ascending in cells. At the tool
/// axis all are; opposite to it in C,A all if the tilt goes so far, since C does not matter.
/// Of three axes the tool axis alone is, from all turns. Limits are compared by the signs of
/// sines of differences, with errors of 1e-15 rad. Source: [KangSuh, eq. (5), (17), (18)].
/// \param centres unit, at most 2^32. \pre pole < centres.size(), 3 <= reach.axes <= 5.
std::vector<FeasibleTurns> feasible_turns(const SetupReach& reach,
                                          std::span<const Vec3> centres,
                                          std::size_t pole);

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
