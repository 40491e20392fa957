// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"

namespace endmill {

/// The section of a mesh by one plane.
struct PlaneSection {
    /// Ordered by their smallest s, then by z there.
    std::vector<SectionCurve> curves;
    /// edges[i][k] is the mesh edge on which points[k] of curves[i] lies
    std::vector<std::vector<CrossedEdge>> edges;
    /// Smallest and largest s in mm of the section of the triangles below
    /// SliceOptions::part_triangles. Empty if the plane crosses none of them.
    std::optional<Interval> part_range;
    std::size_t crossed_triangles = 0;  ///< number of triangles that the plane crosses
};

/// Options of slice.
struct SliceOptions {
    /// PlaneSection::part_range ignores the triangles from this number on. For an offset
    /// mesh these are the strips along the border.
    std::size_t part_triangles = SIZE_MAX;
    /// If set, it is called with the finished share, 0 to 1, by any thread.
    std::function<void(double share)> progress = {};
};

/// The sections of `mesh` by all `planes`.
///
/// 1. A vertex with t > c is above the plane t = c; any other vertex is below it. Every
///    crossed triangle therefore has exactly two crossed edges, and there are no special
///    cases.
/// 2. The point on an edge is below + w (above - below), with the weight
///    w = (c - t_below) / (t_above - t_below). Both triangles of the edge get exactly the
///    same point. If a vertex lies on the plane, the point is that vertex.
/// 3. The segments of the triangles run with the outer side of the triangle on their
///    left. They are linked at common edges to open and closed curves.
/// 4. An open curve whose last end has the smaller s is reversed. Curves without two
///    different points are dropped.
///
/// Curves end or begin at an edge that has more than two triangles, or two with opposite
/// orientation. There the order of the triangles determines which segments are linked.
/// The section by a plane does not depend on the other planes or on the number of
/// threads. Each triangle is visited only by the planes within its range of t;
/// classifying the vertices takes about one visit of each.
/// Source: [JangKimJeong, fig. 7 to 9]; linking: docs/methods/interference.md,
/// section 3.
/// \param mesh any triangles; coordinates within 1e100 mm.
/// \param planes positions in ascending order.
/// \param options the triangles that count in PlaneSection::part_range.
/// \return one section for each plane.
std::vector<PlaneSection> slice(const TriangleMesh& mesh, const DrivePlanes& planes,
                                const SliceOptions& options = {});

}  // namespace endmill
