// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/machine/kinematics.h"

namespace endmill {

/// How the rotary axes may change while the tool stays at a pose.
enum class PoseTurn {
    None,     ///< they may not
    Free,     ///< from any positions of the pose to any other
    Retract,  ///< the same, after the tool has left the part
};

/// A pose of a path, as positions that it can have. Positions count up to full rotations.
struct SearchPose {
    /// rad, positions of both solutions for the motion that ends here.
    std::array<RotaryPositions, 2> arrival;
    /// rad, the same for the motion that begins here. In a singular direction the first
    /// axis may have other positions than at arrival.
    std::array<RotaryPositions, 2> departure;
    std::size_t branches = 2;        ///< number of solutions: 1 or 2
    PoseTurn turn = PoseTurn::None;  ///< at this pose
};

/// Positions of the rotary axes at a pose, unwrapped.
struct BranchChoice {
    std::size_t arrival_branch;    ///< solution at the end of the motion to the pose
    std::size_t departure_branch;  ///< solution at the start of the motion from the pose
    RotaryPositions arrival;       ///< rad
    RotaryPositions departure;     ///< rad
};

/// The first pose that no choice of positions reaches, with the axis that comes closest.
struct BlockedPose {
    std::size_t pose;  ///< index
    std::size_t axis;  ///< index of the axis that exceeds its limit
    double position;   ///< rad, its position with the least excess
    double limit;      ///< rad, the limit that it exceeds
};

/// The best positions of the rotary axes along a path.
struct BranchSearch {
    std::vector<BranchChoice> choices;     ///< one for each pose; empty if blocked
    std::optional<BlockedPose> blocked{};  ///< set if there is no way
    std::size_t retracts = 0;              ///< retracts with a change of positions
    std::size_t branch_changes = 0;        ///< changes of the solution
    double travel = 0;                     ///< rad, sum of all changes of both axes
};

/// The positions along a path that need the fewest retracts, then the least travel of the
/// rotary axes, then the fewest changes of the solution, then the smallest positions at the
/// first pose.
///
/// Between poses each axis turns by the difference nearest to zero and the solution stays.
/// A limited axis has a state for each full rotation within its limits. An axis without
/// limits begins within half a rotation of zero. Forward dynamic programming over the
/// poses finds the minimum exactly, with travel in units of 1e-11 rad.
///
/// \param poses in order; neighbours differ by less than half a rotation of each axis.
/// \param ranges rad, limits of both axes, infinite for an axis without limits.
/// Source: docs/methods/five-axis-paths.md, section 4.
BranchSearch search_branches(std::span<const SearchPose> poses,
                             const std::array<RotaryRange, 2>& ranges);

}  // namespace endmill
