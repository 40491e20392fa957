// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/core/angle.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"

/// \file
/// What a program without a notion of covered area does: parallel planes at a fixed pitch,
/// with a cutter that is dropped onto a mesh at equal steps. Planes and passes go beyond the
/// border as long as the cutter touches the part inside its border, as it does on a slope
/// that falls towards the border. The part's outline in plan is a rectangle.

namespace endmill {

/// How passes in parallel planes are made.
struct DroppedPlanes {
    Angle direction;     ///< of the passes, from +x towards +y
    int planes;          ///< their number, over the part and a radius beyond
    double step;         ///< of dropped positions along a pass, mm
    double thinning;     ///< by how much thinning may move a pass, mm
    double safe_height;  ///< of the tip between passes, mm
};

/// A path in parallel planes with its cost.
struct JudgedPlanes {
    int planes;       ///< number of planes
    double pitch;     ///< distance of the planes, mm
    double cut_mm;    ///< length of the cuts by tips
    double left_mm;   ///< greatest remaining stock measured by the judge
    double gouge_mm;  ///< deepest gouge measured by the judge
};

/// The path: passes all in the same direction, lifted between them.
ToolPath dropped_planes(const DropCutter& drop, const DroppedPlanes& options);

/// The path with the fewest planes for which the judge measures at most `height` of
/// remaining stock. Their number is found by bisection with measurements on rays 0.4 mm
/// apart, and raised until the judge agrees.
/// \throws LimitError if 2000 planes do not suffice.
/// \param part      that the mesh of `drop` approximates, for the judge.
/// \param options   `planes` is ignored.
/// \param height    greatest remaining stock, mm.
/// \param tolerance greatest gouge, mm; only bounds the effort of the judge.
JudgedPlanes fewest_planes(const Part& part, const DropCutter& drop,
                           DroppedPlanes options, double height, double tolerance);

}  // namespace endmill
