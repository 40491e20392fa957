// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/accessibility/visibility.h"
#include "endmill/core/vec.h"
#include "endmill/cutter/tool.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Leaves of a map only what a tool reaches that has a body: the tip at a facet's centroid,
/// the axis along the direction, none of the cylinders may meet a facet, touching included.
/// That of the centroid itself counts too: a cylinder that begins at the tip reaches nothing.
/// The future work of the paper. Source: [KangSuh, section 6].
///
/// Decided for the cylinders as they are, flat ends included, not by a cone about the
/// direction; right but for touches within 1e-14 of the largest coordinate. The cutter is not
/// looked at. On all threads; the answer does not depend on their number. up to 90 bytes a facet.
/// \param visibility of `part` along `directions`.
/// \param body such as `tool_body` gives.
/// \param progress as in VisibilityOptions.
/// \throws DomainError unless the map has a bit for each facet and direction, directions are
///         unit to 1e-9, and each cylinder has a positive finite diameter and finite 0 <= from
///         < to.
void keep_reachable(PartVisibility& visibility, const TriangleMesh& part,
                    std::span<const Vec3> directions, std::span<const ToolCylinder> body,
                    const std::function<void(std::size_t done)>& progress = {});

}  // namespace endmill
