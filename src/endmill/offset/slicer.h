// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"

namespace endmill {

/// An edge of a mesh that a plane t = c crosses: from a vertex with t <= c to one with
/// t > c.
struct CrossedEdge {
    std::int32_t below;  ///< number of the vertex
    std::int32_t above;  ///< number of the vertex
    friend bool operator==(const CrossedEdge&, const CrossedEdge&) = default;
};

/// The section of a mesh by one plane.
struct PlaneSection {
    /// In the order of their smallest s, then of z there.
    std::vector<SectionCurve> curves;
    /// The edge on which points[k] of curves[i] lies: edges[i][k].
    std::vector<std::vector<CrossedEdge>> edges;
    /// Least and greatest s in mm of the triangles that count as the part's own, see
    /// SliceOptions; nothing where the plane meets none of them.
    std::optional<Interval> own_range;
    std::size_t crossed_triangles = 0;  ///< that the plane goes through
};

/// What `slice` may be told.
struct SliceOptions {
    /// Triangles from this number on do not count in PlaneSection::own_range: strips
    /// along a border.
    std::size_t own_triangles = SIZE_MAX;
};

/// The sections of `mesh` by all `planes` in one pass.
///
/// A vertex with t > c is above the plane, any other below, so that every crossed
/// triangle has exactly two crossed edges, no special case. The point on an edge is
/// below + w (above - below) with w = (c - t_below) / (t_above - t_below): the same bits
/// from both triangles, and the vertex itself where it lies on the plane. Segments run so
/// that the triangle's outer side is on their left; they are linked edge to edge. Each
/// plane's section is the same, bit for bit, whatever the other planes are and however
/// many threads there are.
///
/// Where an edge has more than two triangles, or two that are turned against each other,
/// a curve ends or begins there: in the order of the triangles. An open curve whose end
/// has the smaller s is turned round. Curves without two different points are left out.
///
/// Only triangles are looked at whose range of t holds a plane, and those only by these
/// planes; classifying the vertices costs about a look at each.
/// Source: [JangKimJeong, fig. 7 to 9]; the linking is the spec's, section 3.
/// \pre planes.positions do not fall; coordinates are within 1e100 mm.
std::vector<PlaneSection> slice(const TriangleMesh& mesh, const DrivePlanes& planes,
                                const SliceOptions& options = {});

}  // namespace endmill
