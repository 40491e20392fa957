// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"

namespace endmill {

/// The axis that all points of `path` share, unit; +z for a path without points.
/// \return nothing if the axis turns.
std::optional<Vec3> fixed_axis(const ToolPath& path);

/// The rotation about the origin that turns `axis` to +z by the shortest way; the identity
/// for +z.
/// \pre `axis` is a unit vector.
Eigen::Matrix3d upright_rotation(const Vec3& axis);

/// The part turned about the origin; its tool side turns with it.
Part turned(const Part& part, const Eigen::Matrix3d& rotation);

/// The path turned about the origin: tips, axes and contacts.
ToolPath turned(const ToolPath& path, const Eigen::Matrix3d& rotation);

}  // namespace endmill
