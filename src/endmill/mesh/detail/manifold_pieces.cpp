// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/manifold_pieces.h"

#include <algorithm>
#include <limits>
#include <span>

#include "endmill/core/detail/disjoint_sets.h"
#include "endmill/core/error.h"
#include "endmill/mesh/detail/edge_uses.h"

namespace endmill {
namespace {

// The steps of the cut:
// 1. Two triangles are neighbours across an edge if they alone use it, in opposite
//    directions. All other edges are cut.
// 2. The corners of neighbours at the ends of their edge belong to one fan. Every fan
//    becomes a point of the pieces. Where a cut leaves both ends of an edge whole, its
//    triangles meet again in the same two points, and the cut closes; two bodies that
//    touch along an edge are separated so.
// 3. In rare cases, such as a Moebius strip one edge wide, the edge remains non-manifold,
//    because its triangles are in one fan at both ends. These triangles are detached from
//    all their neighbours, and step 1 is repeated.

std::int32_t corner_at(const Triangle& triangle, std::int32_t point)
{
    return static_cast<std::int32_t>(std::ranges::find(triangle, point) -
                                     triangle.begin());
}

// The fans of a mesh's corners: corner k of triangle t has the number 3 t + k.
struct Fans {
    DisjointSets corners;
    bool has_cuts;  // whether an edge of several triangles was cut
};

Fans fans_of(const TriangleMesh& mesh, const EdgeUses& edges,
             const std::vector<bool>& is_detached)
{
    Fans fans{DisjointSets{3 * mesh.triangles().size()}, false};
    edges.for_each([&](const MeshEdge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() == 1)
            return;
        const std::int32_t a = uses[0].triangle();
        const std::int32_t b = uses[1].triangle();
        if (!are_neighbours(uses) || is_detached[a] || is_detached[b]) {
            fans.has_cuts = true;
            return;
        }
        for (const std::int32_t end : edge)
            fans.corners.join(3 * a + corner_at(mesh.triangles()[a], end),
                              3 * b + corner_at(mesh.triangles()[b], end));
    });
    return fans;
}

// The pieces that the fans make, not yet checked.
ManifoldPieces pieces_of(const TriangleMesh& mesh, DisjointSets& fans)
{
    ManifoldPieces pieces;
    std::vector<std::int32_t> point_of_fan(3 * mesh.triangles().size(), -1);
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
        if (repeats_a_corner(mesh.triangles()[t]))
            continue;
        Triangle corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::int32_t& point =
                point_of_fan[fans.least(static_cast<std::int32_t>(3 * t + k))];
            if (point < 0) {
                point = static_cast<std::int32_t>(pieces.points.size());
                pieces.points.push_back(mesh.triangles()[t][k]);
            }
            corners[k] = point;
        }
        pieces.triangles.push_back(corners);
        pieces.source_triangles.push_back(static_cast<std::int32_t>(t));
    }
    return pieces;
}

// Marks the triangles at the non-manifold edges of `pieces`. Returns whether there are
// any.
bool detach_non_manifold(const TriangleMesh& mesh, const ManifoldPieces& pieces,
                         std::vector<bool>& is_detached)
{
    std::vector<Vec3> points;
    points.reserve(pieces.points.size());
    for (const std::int32_t point : pieces.points)
        points.push_back(mesh.points()[point]);
    bool is_any = false;
    const TriangleMesh cut{std::move(points), pieces.triangles};
    EdgeUses{cut}.for_each([&](const MeshEdge&, std::span<const EdgeUse> uses) {
        if (uses.size() == 1 || are_neighbours(uses))
            return;
        is_any = true;
        for (const EdgeUse& use : uses)
            is_detached[pieces.source_triangles[use.triangle()]] = true;
    });
    return is_any;
}

}  // namespace

ManifoldPieces manifold_pieces(const TriangleMesh& mesh)
{
    constexpr std::size_t most_corners = std::numeric_limits<std::int32_t>::max();
    require(mesh.triangles().size() <= most_corners / 3,
            "manifold_pieces: at most 715 827 882 triangles");
    const EdgeUses edges{mesh};
    std::vector<bool> is_detached(mesh.triangles().size(), false);
    for (;;) {
        Fans fans = fans_of(mesh, edges, is_detached);
        ManifoldPieces pieces = pieces_of(mesh, fans.corners);
        if (!fans.has_cuts || !detach_non_manifold(mesh, pieces, is_detached)) {
            pieces.has_detached =
                std::ranges::find(is_detached, true) != is_detached.end();
            return pieces;
        }
    }
}

}  // namespace endmill
