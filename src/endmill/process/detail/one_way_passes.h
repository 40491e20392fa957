// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"
#include "endmill/process/feed_plan.h"
#include "endmill/surface/detail/explicit_surface.h"

namespace endmill {

/// One-way passes of a ball along +x over a surface z(x, y). Each pass lies to the right
/// of the one before, so all passes mill down. The default members are those of the
/// reference path REF.
/// Source: [ParkMaeng, section 5]; docs/methods/ball-end-milling.md, section 7.
struct OneWayPasses {
    ExplicitSurface surface;
    XyRectangle extent;               ///< range of the contacts
    double radius = 5;                ///< of the ball, mm
    double cusp = 0.2;                ///< scallop height, mm
    double outside_tolerance = 0.01;  ///< largest outward chord error, mm
    double stock_top = 20;            ///< height of the flat top of the stock, mm
    int samples = 600;  ///< steps along a pass in the search for its narrowest interval
    PreviousPass first_pass = PreviousPass::Edge;  ///< the material beside the first pass
};

/// y of the passes in mm, from the low to the high end of the extent. The distance of two
/// passes on the surface is sqrt(8 h r0 / (1 + r0 k)) at the sample of the first one
/// where this is least.
std::vector<double> pass_places(const OneWayPasses& plan);

/// The cutting moves of a path.
struct MilledPath {
    std::vector<SegmentCut> cuts;  ///< geometry at the middle of each move
    std::vector<Vec3> from;        ///< ball centre at the begin of each move, mm
    std::vector<Vec3> to;          ///< ball centre at the end of each move, mm
};

/// The moves in the order of cutting, from the highest y down. The length of a move
/// follows from the tolerance and the curvature of the pass at its begin, and is at most
/// 10 mm. The pick feed is measured to the pass before. Source: [ParkMaeng, eq. (13)].
MilledPath milled_path(const OneWayPasses& plan);

/// Total length of the moves, mm.
double length_mm(const std::vector<SegmentCut>& cuts);

/// The moves with their lengths scaled by one factor to the total `length_mm`.
std::vector<SegmentCut> stretched(std::vector<SegmentCut> cuts, double length_mm);

/// The tool path of the moves. The tip reaches and leaves each pass along z, from and to
/// the height `safe_height` in mm.
ToolPath milled_tool_path(const MilledPath& milled, double radius, double safe_height);

/// Non-cutting travel of the tip in mm: lifts to `return_z`, returns at that height,
/// plunges, the return from the last pass to the start, and `overrun` for each pass.
double noncut_travel_mm(const MilledPath& milled, double radius, double return_z,
                        double overrun);

}  // namespace endmill
