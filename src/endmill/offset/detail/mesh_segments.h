// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"
#include "endmill/offset/slicer.h"

namespace endmill {

/// Where planes cross triangles, those of a plane together, in the order of the
/// triangles. Number k of a plane is at [first[plane] + k]. A triangle's outer side is on
/// the left of its segment.
struct MeshSegments {
    std::vector<CrossedEdge> from;
    std::vector<CrossedEdge> to;
    std::vector<std::int32_t> triangle;
    std::vector<std::size_t> first;  ///< one more than planes
};

/// Most planes that `mesh_segments` takes.
inline constexpr std::size_t most_planes_a_batch = 65535;

/// The segments of all planes t = positions[k] in two passes over the triangles, of which
/// the second only looks at those that a plane crosses.
/// \pre positions do not fall, and there are at most `most_planes_a_batch`.
MeshSegments mesh_segments(const TriangleMesh& mesh, const DriveFrame& frame,
                           std::span<const double> positions);

/// The point below + w (above - below), w = (c - t_below) / (t_above - t_below), of the
/// plane t = c = `position` on an edge that it crosses.
inline SectionPoint point_on(const CrossedEdge& edge, std::span<const Vec3> points,
                             const DriveFrame& frame, double position)
{
    const Vec3& below = points[edge.below];
    const Vec3& above = points[edge.above];
    const double t = frame.across(below);
    const double s = frame.along(below);
    const double w = (position - t) / (frame.across(above) - t);
    return {s + w * (frame.along(above) - s), below.z() + w * (above.z() - below.z())};
}

}  // namespace endmill
