// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"

/// \file
/// How a path is moved onto a machine with rotary axes, and the result. `machine_path.h` has
/// the algorithm.

namespace endmill {

/// What happens close to a singular direction, where the first rotary axis has no effect.
enum class SingularRule {
    Exact,    ///< nothing changes; the axis may turn far on a short way
    Turn,     ///< axes within the singular cone become the singular direction
    Retract,  ///< the same, and the first axis turns there with the tool off the part
};

/// How a path is moved onto a machine.
struct MachinePathOptions {
    /// Joint: the control moves X, Y, Z and the rotary axes evenly. Tcp: it keeps the tip on
    /// a straight line.
    Interpolation frame = Interpolation::Joint;
    /// mm, above 0: largest deviation of tip and reference point from the path, and of the
    /// axis at a distance of the cutter's radius.
    double tolerance = 0.005;
    Cutter cutter = Cutter::ball(5);              ///< for the tolerance of the axis
    SingularRule singular = SingularRule::Exact;  ///< near singular directions
    Angle singular_cone =
        Angle::degrees(0.1);  ///< half angle, at least 0, below 10 degrees
    /// mm, above 0: distance beyond the sphere around the path to which the tool retracts
    /// where no other motion of the rotary axes leads on. None: it never does.
    std::optional<double> retract = {};
    /// mm, heights in the part from which the rotary axes may turn between two rapids with
    /// the tip at rest; none: nowhere.
    std::optional<double> free_height = {};
    /// mm/min, feed of rapids that turn an axis. None: they stay rapids.
    std::optional<double> rapid_feed = {};
};

/// What moving a path onto a machine did, and what follows.
struct MachinePathReport {
    std::size_t pieces = 0;           ///< moves of the machine
    std::size_t retracts = 0;         ///< retracts to reorient the tool
    std::size_t branch_changes = 0;   ///< changes between the two solutions
    std::size_t singular_points = 0;  ///< points whose axis became a singular direction
    double rotary_travel = 0;         ///< rad, all turns of both axes
    /// Bound, from the path to tip and reference point. Rapids, which may deviate by 0.1 mm,
    /// do not count.
    double max_tip_error_mm = 0;
    double max_axis_error = 0;           ///< rad, bound
    double max_tip_feed_mm_per_min = 0;  ///< bound of the speed of the tip in the part
    double rate_limited_min = 0;  ///< min, of pieces that take longer because of a rate
    double time_min = 0;          ///< min, of all moves at feed
};

/// A tool path as the motions of a machine.
struct MachinePath {
    /// Ends of the motions, with the machine and its positions. A feed is that of the tip
    /// in the part, as the machine moves.
    ToolPath path;
    /// min, time of the motion to each point; infinite for a rapid and for a move without a
    /// feed.
    std::vector<double> minutes;
    std::vector<std::size_t>
        rows;                  ///< for each point, the index in the path that was given
    MachinePathReport report;  ///< of all motions
};

/// Checks the options.
/// \throws DomainError for the frame Linear, a tolerance below 1e-6 mm, a cone of 10 degrees
///         or more, a retract or a feed that is not above 0, and SingularRule::Retract
///         without a retract.
void require_sound(const MachinePathOptions& options);

}  // namespace endmill
