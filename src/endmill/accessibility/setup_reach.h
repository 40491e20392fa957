// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/rotary_angles.h"
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

}  // namespace endmill
