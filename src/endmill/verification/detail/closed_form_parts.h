// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"

namespace endmill {

/// A path that cuts straight through `tips`, in mm.
ToolPath tip_path(const std::vector<Vec3>& tips);

/// The flat parallelogram with a corner at the origin and these sides, in mm.
Part plane_part(const Vec3& along_u, const Vec3& along_v);

/// The cylinder (x, rho cos t, rho sin t) over 0 <= x <= 4 mm and `angles`, in rad, less
/// than half a turn.
Part cylinder_part(double rho, Interval angles);

/// Passes of a ball R 5 along x on z = 0, `apart` mm apart, that cover 0 ... 20 by
/// 0 ... 12 mm; links run outside.
/// \param left_out number of a pass that is not cut.
ToolPath level_passes(double apart, std::optional<int> left_out);

/// Passes of a ball R 5 along that cylinder, its centres `centre_radius` mm from the axis,
/// by steps of `step` rad from the angle `from` until over 2 rad on.
ToolPath passes_along_cylinder(double centre_radius, double from, double step);

/// Passes of a ball R 5, 0.1 mm apart, over a plane of 6 by 6 mm that rises along x by the
/// angle `slope` in rad; all `lowered` mm too low.
ToolPath lowered_path(double slope, double lowered);

}  // namespace endmill
