// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// The path as a program in the subset of RS-274 that three-axis controls share: plain
/// decimals, and the words X, Y, Z, F, S, G0 and G1 only where they change. Rapid moves
/// are G0, all others G1, or G2 and G3 if arcs are wanted. Coordinates are those of the
/// tip; the control applies the tool length.
///
/// Before the first point, the tool rises to the safe height and moves to the place above
/// the point. After the last point it rises again. At a tool change it rises, the tool is
/// changed, and the new tool returns to the place above the last point and descends to
/// it. The control states whether X and Y or Z move first after a change of the tool.
///
/// With PathControl::Tolerance the path control is `G64 P` with half the tolerance, so
/// that the rounding of corners by the control leaves the other half. P is rounded to the
/// nearest number with enough decimals to be within 1 % of that half. If nine decimals are
/// not enough, or the tolerance is 0, the program has G61 (exact path). Without a tolerance
/// it has plain `G64`. F has as many decimals as coordinates, and S as the control says,
/// without trailing zeros.
///
/// Arcs: the program differs from the path by at most `arc_tolerance`, rounding included;
/// `max_arc_error_mm` is the bound reached. Ramps: the path of `with_ramps`, which removes
/// the same material. With an `approach_distance` slopes begin at the end of the rapid.
///
/// \param path the path.
/// \param options format and missing data.
/// \throws DomainError for a path without points; for decimals outside 0 to 9; if a move
///         at feed has no feed; for a feed or spindle speed that is not above 0 after
///         rounding; for a negative tool number, or 0 where the control has words for
///         the tool; if the safe height lies below the path; if the tolerance or the dwell
///         is below 0; for an arc tolerance or an approach distance that is not above 0; for a ramp that is not between 0 and 90 degrees; for a number that is not
///         finite; for an unsound control; if the control has no words for a second tool,
///         the coolant, the dwell or arcs, or takes shorter lines only.
/// \throws GeometryError unless the axis of every point is +z: three axes cannot turn the
///          tool.
/// Source: docs/methods/removal.md, section 6.
WrittenProgram gcode(const ToolPath& path, const GcodeOptions& options = {});

}  // namespace endmill
