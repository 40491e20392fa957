// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"
#include "endmill/process/feed_plan.h"
#include "endmill/surface/detail/explicit_surface.h"

namespace endmill {

/// One-way passes of a ball along +x over a surface z(x, y), each to the right of the one
/// before, so that all mill down: the path REF of the spec if all else is as given here.
/// Source: [ParkMaeng, section 5]; spec of ball-end milling, section 7.
struct OneWayPasses {
    ExplicitSurface surface;
    Rectangle extent;                 ///< over which the contacts go
    double radius = 5;                ///< of the ball, mm
    double cusp = 0.2;                ///< height between passes, mm
    double outside_tolerance = 0.01;  ///< mm, by which chords leave the surface outwards
    double stock_top = 20;            ///< mm, horizontal
    int samples = 600;  ///< steps along a pass at which its interval is looked for
    PreviousPass first_pass = PreviousPass::Edge;  ///< what the first pass meets
};

/// y of the passes, from the extent's low end to its high one: each as far from the one before
/// as the cusp allows where it allows least, sqrt(8 h r0 / (1 + r0 k)) apart on the surface.
std::vector<double> pass_places(const OneWayPasses& plan);

/// A path that is cut.
struct MilledPath {
    std::vector<SegmentCut> cuts;  ///< geometry at the middle of each move
    std::vector<Vec3> from;        ///< the ball's centre where each move begins, mm
    std::vector<Vec3> to;          ///< and ends
};

/// The moves in the order in which they are cut, from the highest y down. A move is as long
/// as the tolerance allows by the curvature of the pass where it begins, 10 mm at most. The
/// pick feed is that to the pass before, by eq. (13).
MilledPath milled_path(const OneWayPasses& plan);

/// Sum of the lengths of the moves, mm.
double length_mm(const std::vector<SegmentCut>& cuts);

/// The moves with their lengths in proportion, so that they sum up to `length_mm`.
std::vector<SegmentCut> stretched(std::vector<SegmentCut> cuts, double length_mm);

/// The same as tips: each pass is reached from above and left upwards, from and to the height
/// `safe_height` of tips, in mm.
ToolPath milled_tool_path(const MilledPath& milled, double radius, double safe_height);

/// What tips travel but for cutting, in mm: lifts to `return_z`, ways back at that height,
/// plunges, at the end back to the start, and `overrun` more each time.
double noncut_travel_mm(const MilledPath& milled, double radius, double return_z,
                        double overrun);

}  // namespace endmill
