// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/linking.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// What is left in one drive plane.
struct PlaneCurves {
    double across;                         ///< t of the plane, mm
    std::span<const TrimmedCurve> curves;  ///< reference points
};

/// Joins trimmed curves to one path of tips: each curve is a pass, reached by a plunge
/// and left by a retract, with a rapid at the safe height between. Zigzag cuts the curves
/// of every other plane backwards, the last curve first. Passes count from 0; the lift to
/// a pass counts to it. A curve of one point is a plunge alone. The axis is +z.
/// Source: specification of the interference removal, section 1.
/// \throws DomainError if the axis of `options` is not +z.
/// \throws GeometryError if the safe height lies below a tip.
ToolPath link_sections(std::span<const PlaneCurves> planes, const DriveFrame& frame,
                       const Cutter& cutter, const LinkOptions& options);

}  // namespace endmill
