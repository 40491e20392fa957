// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"

namespace endmill {

/// A path with straight cutting moves through `tips`, in mm.
ToolPath tip_path(const std::vector<Vec3>& tips);

/// The parallelogram with one corner at the origin and the given sides, in mm.
Part plane_part(const Vec3& along_u, const Vec3& along_v);

/// The cylinder (x, rho cos t, rho sin t) over 0 <= x <= 4 mm and `angles`, in rad, less
/// than half a turn.
Part cylinder_part(double rho, Interval angles);

/// Passes of a ball of radius 5 along x on the plane z = 0, `apart` mm apart. They cover
/// 0 <= x <= 20, 0 <= y <= 12 mm; the links lie outside.
/// \param left_out number of a pass to leave out; none: all are cut.
ToolPath level_passes(double apart, std::optional<int> left_out);

/// Passes of a ball of radius 5 along the axis of `cylinder_part`, with ball centres
/// `centre_radius` mm from the axis, at steps of `step` rad from the angle `from` to at
/// least `from` + 2 rad.
ToolPath passes_along_cylinder(double centre_radius, double from, double step);

/// Passes of a ball of radius 5, 0.1 mm apart, over a plane of 6 by 6 mm that rises along
/// x at the angle `slope` in rad. All tips are `lowered` mm too low.
ToolPath lowered_path(double slope, double lowered);

}  // namespace endmill
