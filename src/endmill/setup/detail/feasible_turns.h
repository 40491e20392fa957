// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// Number of turns of a part about its tool axis that are tried: steps of 5 degrees.
inline constexpr std::size_t turns_about_tool_axis = 72;

/// The machine's axes in coordinates of the part, `turn` steps of 5 degrees about the
/// tool axis. A machine of four axes has R1 of A,B, with R2 at rest.
/// \param reach the machine. \param tool_axis unit. \param turn below
///         turns_about_tool_axis.
RotaryFrame frame_at(const RotaryReach& reach, const Vec3& tool_axis, std::size_t turn);

/// A run of turns about the tool axis from which the machine reaches a cell: `first`,
/// `first` + 1, ..., `count` of them, continued at 0 after the last turn.
struct FeasibleTurns {
    std::uint32_t cell;
    std::uint8_t first;
    std::uint8_t count;  ///< 1 to `turns_about_tool_axis`

    /// Tests whether the run contains `turn`.
    bool hold(std::size_t turn) const
    {
        return (turn + turns_about_tool_axis - first) % turns_about_tool_axis < count;
    }
};

/// Finds for every cell the turns from which the machine reaches it, with the centre of
/// cell `pole` as the tool axis. Limits are met to 1e-9 rad.
///
/// A cell may have several runs. The tool axis itself is reached from all turns. In C,A
/// its opposite is reached from all turns if the tilt goes that far, because C has no
/// effect there. A machine of three axes reaches the tool axis only. Limits are compared
/// by the signs of sines of differences, whose errors are 1e-15 rad, instead of by arc
/// tangents.
/// Source: [KangSuh, eq. (5), (17), (18)].
/// \param reach the machine. \param centres unit, at most 2^32.
/// \param pole below centres.size().
/// \return runs, ascending in cells.
std::vector<FeasibleTurns> feasible_turns(const RotaryReach& reach,
                                          std::span<const Vec3> centres,
                                          std::size_t pole);

}  // namespace endmill
