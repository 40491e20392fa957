// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <variant>

#include "endmill/cutter/cutter.h"
#include "endmill/machine/kinematics.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/machine_path_options.h"

/// \file
/// A tool path as motions of a machine with rotary axes: which of the two solutions and how
/// many full rotations the axes take, and the pieces into which moves are divided so that
/// the machine stays within the tolerance.

namespace endmill {

/// The poses of a path with linear motion between them: the path itself, or for a path that
/// a machine interpolates, poses so close that linear motion deviates from the machine's by
/// at most `tolerance` at the tip and at the rim of the cutter.
/// \param tolerance mm, above 0.
/// \throws DomainError for a tolerance that is not above 0.
ToolPath linear_path(const ToolPath& path, const Cutter& cutter, double tolerance);

/// mm, height in the part from which the rotary axes may turn between two rapids:
/// `default_clearance_mm` above the moves at feed. -infinity without such moves.
double free_height(const ToolPath& path);

/// The first point of a path that no positions of the rotary axes reach.
struct BlockedPoint {
    std::size_t row;  ///< index of the point
    std::size_t
        axis;         ///< index of the axis that comes closest, from the part to the tool
    double position;  ///< rad, its position with the least excess
    double limit;     ///< rad, the limit that it exceeds
};

/// Moves a path onto a machine whose linear axes have no limits.
/// \param path, setup, options as for `machine_path`.
/// \return the motions, or the point at which the limits of the rotary axes end them.
/// \throws as `machine_path`, except for axes out of reach and for X, Y and Z.
std::variant<MachinePath, BlockedPoint> machine_motions(
    const ToolPath& path, const PartOnMachine& setup,
    const MachinePathOptions& options = {});

/// Moves a path onto a machine.
///
/// The tool moves along `path` by its own interpolation (linear between poses). The
/// solution and the full rotations of the rotary axes are those of `search_branches`: the
/// fewest retracts, then the least travel. Each move is halved until the machine's motion
/// stays within the tolerance by proved bounds. New points are exactly on the path.
///
/// At a singular direction the first axis turns to where the path goes on, with tip and
/// axis at rest in the part. With a retract height it may also turn after the tool has
/// left the part along its axis to a sphere around the path, on which it goes round.
///
/// A move takes max(way of the tip, radius times turn of the axis) / feed, and longer where
/// an axis would exceed its rate.
///
/// \param path unit axes; neighbours less than 179.9 degrees apart. At least one point.
/// \param setup machine with two rotary axes that tilt the tool, or fewer.
/// \throws DomainError for a path without points, an axis that is not a unit vector, a
///         number that is not finite, or options out of their domain.
/// \throws GeometryError with the point: for a machine whose axes do not tilt the tool, for
///         opposite axes of neighbours, an axis out of reach, no way without a retract, and
///         positions beyond the travel of X, Y or Z.
/// Source: docs/methods/five-axis-paths.md, sections 3 to 5.
MachinePath machine_path(const ToolPath& path, const PartOnMachine& setup,
                         const MachinePathOptions& options = {});

}  // namespace endmill
