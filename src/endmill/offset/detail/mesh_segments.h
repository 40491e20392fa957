// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"

namespace endmill {

/// The segments in which planes cross triangles. Those of one plane are stored together,
/// in the order of the triangles: segment k of a plane is at index first[plane] + k. The
/// outer side of a triangle is on the left of its segment.
struct MeshSegments {
    /// The edge at which each segment begins.
    std::vector<CrossedEdge> from;
    /// The edge at which it ends.
    std::vector<CrossedEdge> to;
    /// The triangle that it crosses.
    std::vector<std::int32_t> triangle;
    std::vector<std::size_t> first;  ///< one more than planes
};

/// The largest number of planes that mesh_segments accepts.
inline constexpr std::size_t most_planes_a_batch = 65535;

/// The segments of all planes t = positions[k], in two passes over the triangles. The
/// second pass visits only the crossed triangles.
/// \param mesh the triangles.
/// \param frame the direction of the planes.
/// \param positions t in mm, ascending, at most `most_planes_a_batch`.
MeshSegments mesh_segments(const TriangleMesh& mesh, const DriveFrame& frame,
                           std::span<const double> positions);

/// The point below + w (above - below), w = (c - t_below) / (t_above - t_below), in which
/// the plane t = c = `position` meets an edge that it crosses.
/// \param edge the edge.
/// \param points of the mesh, mm.
/// \param frame the direction of the plane.
/// \param position c in mm.
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
