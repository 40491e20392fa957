// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// How far above the moves at feed the safe height lies at least if nobody says, in mm.
inline constexpr double default_clearance_mm = 5;

/// What a path does not say of itself, and how its program is spelled.
struct GcodeOptions {
    std::string name = {};                       ///< for the comment at the start
    std::optional<Cutter> cutter = {};           ///< ditto
    std::optional<double> feed_mm_per_min = {};  ///< where the path gives none
    std::optional<double> spindle_rpm = {};      ///< where the path gives none
    int tool = 1;                                ///< where the path gives none
    std::optional<double> safe_height = {};      ///< mm; default 5 above the moves at
                                                 ///< feed, but not below a rapid
    std::optional<double> tolerance = {};        ///< mm, that the path was planned to
    int decimals = 4;                            ///< of coordinates, 0 to 9
    bool line_numbers = false;                   ///< N1, N2, ... on every block
    bool comments = true;                        ///< the one at the start
};

/// The path as a program in the subset of RS-274 that 3-axis controls share: millimetres,
/// plain decimals, the words X Y Z F S and G0, G1 only where they change. Rapid moves are
/// G0, all others G1. Before the first point the tool rises to the safe height and goes
/// over it; after the last it rises again; where the path changes the tool, both.
/// Coordinates are tips; the tool's length is the control's affair.
///
/// `G64 P` is half the tolerance, rounded down, so that what the control rounds off at
/// corners leaves the other half; without tolerance it is plain `G64`. F and S have as
/// many digits as coordinates, less the zeros at their end.
/// Source: spec of the removal, section 6.
/// \throws DomainError for a path without points; for decimals out of range; if a move at
///         feed has none; for a feed or a spindle speed that is not above 0 once rounded;
///         for a negative tool number; if the safe height lies below the path; if the
///         tolerance is not above 0; for a number that is not finite.
/// \throws GeometryError unless the axis of every point is +z: three axes cannot turn it.
WrittenProgram gcode(const ToolPath& path, const GcodeOptions& options = {});

}  // namespace endmill
