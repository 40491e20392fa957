// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/control.h"
#include "endmill/post/program.h"

namespace endmill {

/// Default clearance in mm between the moves at feed and the safe height.
inline constexpr double default_clearance_mm = 5;

/// Data that a path does not contain, and the format of its program.
struct GcodeOptions {
    std::string name = {};  ///< name of the program, for the comment at the start
    std::optional<Cutter> cutter = {};           ///< cutter, for the comment at the start
    std::optional<double> feed_mm_per_min = {};  ///< mm/min, for moves without a feed
    std::optional<double> spindle_rpm = {};  ///< rpm, for moves without a spindle speed
    int tool = 1;                            ///< tool number, for moves without one
    /// mm. Default: `default_clearance_mm` above the moves at feed, but not below a rapid
    /// of the path.
    std::optional<double> safe_height = {};
    /// mm, tolerance for which the path was planned; 0 if it may deviate to one side only.
    std::optional<double> tolerance = {};
    std::optional<int> decimals = {};    ///< of coordinates, 0 to 9; none: the control's
    bool line_numbers = false;           ///< whether every block has a number N1, N2, ...
    bool comments = true;                ///< whether the comment at the start is written
    Control control = {};                ///< words and number formats
    ProgramUnit unit = ProgramUnit::Mm;  ///< unit of the program
    Coolant coolant = Coolant::Off;      ///< coolant during the program
    double dwell_s = 0;                  ///< s, wait after each start of the spindle
    /// Feeds of the descents that the path does not have: back to the path after a tool
    /// change. The feeds of its own moves are those of the path.
    FeedSettings feeds = {};
    /// mm, above 0: descents to a cut are rapids down to this height above the point at
    /// which they end. The stock must not be higher there. None: no such rapids.
    std::optional<double> approach_distance = {};
    /// Slope of the descents of the path; none: straight down. The descent after a tool
    /// change stays vertical.
    std::optional<Angle> ramp = {};
    /// mm, above 0: largest distance of arcs from the moves that they replace; none: no
    /// arcs.
    std::optional<double> arc_tolerance = {};
};

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
