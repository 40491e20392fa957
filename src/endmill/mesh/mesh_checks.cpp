// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/mesh_checks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "endmill/core/detail/disjoint_sets.h"
#include "endmill/core/orientation.h"
#include "endmill/mesh/detail/edge_uses.h"
#include "endmill/mesh/detail/manifold_pieces.h"
#include "endmill/mesh/detail/place_order.h"

namespace endmill {
namespace {

// A sum with Neumaier's compensation: it also sums up the rounding errors, so that the
// error of the result does not grow with the number of terms.
class CompensatedSum {
public:
    void add(double term)
    {
        const double sum = sum_ + term;
        rounding_ +=
            std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
        sum_ = sum;
    }

    double value() const { return sum_ + rounding_; }

private:
    double sum_ = 0;
    double rounding_ = 0;
};

// Triangles by which their points are fetched in advance.
constexpr std::size_t triangles_ahead = 12;

// Sums over all triangles.
struct Measures {
    std::size_t without_area = 0;
    std::size_t with_three_corners = 0;
    CompensatedSum doubled_area;    // mm^2
    CompensatedSum sixfold_volume;  // mm^3
};

// The volume is that of the tetrahedra between the triangles and a point near the mesh.
Measures measures(const TriangleMesh& mesh)
{
    Measures sum;
    if (mesh.triangles().empty())
        return sum;
    // near the mesh, so that volumes lose no digits far from the origin
    const Vec3 origin = mesh.corners(0)[0];
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        mesh.prefetch_corners(k + triangles_ahead);
        const auto [a, b, c] = mesh.corners(k);
        const Vec3 doubled = (b - a).cross(c - a);
        sum.doubled_area.add(doubled.norm());
        sum.sixfold_volume.add((a - origin).dot(doubled));
        sum.with_three_corners += !repeats_a_corner(mesh.triangles()[k]);
        sum.without_area += are_collinear(a, b, c);
    }
    return sum;
}

// Sums over all edges.
struct EdgeReport {
    std::size_t boundary = 0;
    std::size_t non_manifold = 0;
    std::optional<MeshEdge> first_non_manifold;
    std::size_t inconsistent = 0;
    std::size_t joints = 0;  // number of joins that made one component of two
    bool all_even = true;
    bool all_balanced = true;
    std::size_t duplicates = 0;
    std::vector<bool> is_at_break;  // of each point, see points_at_breaks
};

// Each join of two sets of triangles reduces the number of components by one.
// `name(point)` is the number of a point in the mesh; `points` is their count.
template <typename Name>
EdgeReport edge_report(std::size_t points, const EdgeUses& edges, std::size_t triangles,
                       const Name& name)
{
    EdgeReport report;
    report.is_at_break.resize(points);
    DisjointSets components{triangles};
    edges.for_each([&](const MeshEdge& ends, std::span<const EdgeUse> uses) {
        std::ptrdiff_t surplus = 0;  // of triangles that run along the edge forwards
        for (const EdgeUse& use : uses)
            surplus += use.is_forward() ? 1 : -1;
        for (const EdgeUse& use : uses.subspan(1))
            report.joints += components.join(uses.front().triangle(), use.triangle());
        report.boundary += uses.size() == 1;
        report.inconsistent += uses.size() == 2 && surplus != 0;
        report.all_even &= uses.size() % 2 == 0;
        report.all_balanced &= surplus == 0;
        if (are_neighbours(uses))
            return;
        const auto [low, high] = std::minmax({name(ends[0]), name(ends[1])});
        report.is_at_break[low] = report.is_at_break[high] = true;
        if (uses.size() > 2) {
            ++report.non_manifold;
            const MeshEdge first =
                report.first_non_manifold.value_or(MeshEdge{low, high});
            report.first_non_manifold = std::min(first, MeshEdge{low, high});
        }
    });
    report.duplicates = duplicate_triangles(edges).size();
    return report;
}

// Triangles in no order are first ordered by place, so that the work on their edges finds
// neighbours in the caches. The report does not depend on the order.
EdgeReport edge_report(const TriangleMesh& mesh)
{
    const std::size_t points = mesh.points().size();
    const std::size_t triangles = mesh.triangles().size();
    if (!are_scattered(mesh))
        return edge_report(points, EdgeUses{mesh}, triangles,
                           [](std::int32_t point) { return point; });
    const TrianglesByPlace by_place = triangles_by_place(mesh);
    return edge_report(points, EdgeUses{by_place.points.size(), by_place.triangles},
                       triangles,
                       [&](std::int32_t point) { return by_place.points[point]; });
}

// The numbers of the points that are marked.
std::vector<std::int32_t> marked_points(const std::vector<bool>& is_marked)
{
    std::vector<std::int32_t> marked;
    for (std::size_t k = 0; k < is_marked.size(); ++k)
        if (is_marked[k])
            marked.push_back(static_cast<std::int32_t>(k));
    return marked;
}

// The triangles at points that are marked.
TriangleMesh triangles_at(const std::vector<bool>& is_marked, const TriangleMesh& mesh)
{
    std::vector<Triangle> kept;
    for (const Triangle& triangle : mesh.triangles()) {
        const auto& [a, b, c] = triangle;
        if (is_marked[a] || is_marked[b] || is_marked[c])
            kept.push_back(triangle);
    }
    return {{mesh.points().begin(), mesh.points().end()}, std::move(kept)};
}

// The manifold pieces of a mesh, or of a part of it that has all their boundaries.
struct PiecesAtBreaks {
    ManifoldPieces pieces;
    std::vector<bool> is_at_break;  // points of the mesh through which boundaries run
};

// Only the triangles at breaks have a boundary, unless triangles had to be detached.
PiecesAtBreaks pieces_at_breaks(const TriangleMesh& mesh,
                                std::span<const std::int32_t> points_at_breaks)
{
    std::vector<bool> is_at_break(mesh.points().size(), false);
    for (const std::int32_t point : points_at_breaks)
        is_at_break[point] = true;
    ManifoldPieces pieces = manifold_pieces(triangles_at(is_at_break, mesh));
    if (!pieces.has_detached)
        return {std::move(pieces), std::move(is_at_break)};
    return {manifold_pieces(mesh), std::vector<bool>(mesh.points().size(), true)};
}

// Which points of manifold pieces lie on their boundary. Edges where `pieces` end because
// the other triangles were left out do not count.
std::vector<bool> boundary_points(const TriangleMesh& mesh, const PiecesAtBreaks& cut)
{
    std::vector<bool> is_on_boundary(mesh.points().size(), false);
    EdgeUses{mesh}.for_each([&](const MeshEdge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() == 1 && cut.is_at_break[cut.pieces.points[edge[0]]] &&
            cut.is_at_break[cut.pieces.points[edge[1]]])
            is_on_boundary[edge[0]] = is_on_boundary[edge[1]] = true;
    });
    return is_on_boundary;
}

// The half-edge structure of all triangles at boundary points. The fans of these points
// are complete in it, so it has the boundary of the whole mesh.
OpenMesh::TriConnectivity half_edges_at(const std::vector<bool>& is_on_boundary,
                                        const TriangleMesh& pieces)
{
    omlog().disable();
    omerr().disable();
    OpenMesh::TriConnectivity result;
    result.resize(pieces.points().size(), 0, 0);
    for (const auto& [a, b, c] : pieces.triangles()) {
        if (!is_on_boundary[a] && !is_on_boundary[b] && !is_on_boundary[c])
            continue;
        const OpenMesh::VertexHandle corners[] = {OpenMesh::VertexHandle{a},
                                                  OpenMesh::VertexHandle{b},
                                                  OpenMesh::VertexHandle{c}};
        [[maybe_unused]] const auto face = result.add_face(corners, 3);
        assert(face.is_valid());
    }
    return result;
}

// The boundary loop through `start`. Each boundary point has one outgoing boundary
// half-edge. It runs against the direction of the triangles, so the loop follows its
// predecessors.
std::vector<std::int32_t> loop_through(OpenMesh::VertexHandle start,
                                       const OpenMesh::TriConnectivity& half_edges)
{
    std::vector<std::int32_t> loop;
    auto side = half_edges.halfedge_handle(start);
    do {
        loop.push_back(half_edges.from_vertex_handle(side).idx());
        side = half_edges.prev_halfedge_handle(side);
    } while (half_edges.from_vertex_handle(side) != start);
    return loop;
}

// A loop given by the points of the mesh instead of those of the pieces.
BoundaryLoop in_mesh(std::span<const std::int32_t> loop, const TriangleMesh& mesh,
                     const ManifoldPieces& pieces)
{
    BoundaryLoop result{{}, 0};
    for (const std::int32_t point : loop)
        result.points.push_back(pieces.points[point]);
    for (std::size_t k = 0; k < loop.size(); ++k)
        result.length += (mesh.points()[result.points[k]] -
                          mesh.points()[result.points[(k + 1) % loop.size()]])
                             .norm();
    // Not std::ranges::rotate, which clang 14 does not compile with libstdc++ 12.
    std::rotate(result.points.begin(), std::ranges::min_element(result.points),
                result.points.end());
    return result;
}

}  // namespace

MeshReport mesh_report(const TriangleMesh& mesh)
{
    const Measures sum = measures(mesh);
    const EdgeReport edges = edge_report(mesh);
    const bool has_edges = sum.with_three_corners > 0;
    MeshReport report{};
    report.boundary_edges = edges.boundary;
    report.non_manifold_edges = edges.non_manifold;
    report.first_non_manifold_edge = edges.first_non_manifold;
    report.inconsistent_edges = edges.inconsistent;
    report.components = sum.with_three_corners - edges.joints;
    report.degenerate_triangles = sum.without_area;
    report.duplicate_triangles = edges.duplicates;
    report.area = sum.doubled_area.value() / 2;
    report.points_at_breaks = marked_points(edges.is_at_break);
    report.closed = has_edges && edges.all_even;
    if (has_edges && edges.all_balanced)
        report.volume = sum.sixfold_volume.value() / 6;
    return report;
}

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh)
{
    return boundary_loops(mesh, marked_points(edge_report(mesh).is_at_break));
}

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh,
                                         std::span<const std::int32_t> points_at_breaks)
{
    if (points_at_breaks.empty())
        return {};
    PiecesAtBreaks at_breaks = pieces_at_breaks(mesh, points_at_breaks);
    ManifoldPieces& pieces = at_breaks.pieces;
    std::vector<Vec3> points;
    points.reserve(pieces.points.size());
    for (const std::int32_t number : pieces.points)
        points.push_back(mesh.points()[number]);
    const TriangleMesh cut{std::move(points), std::move(pieces.triangles)};
    std::vector<bool> is_to_do = boundary_points(cut, at_breaks);
    const OpenMesh::TriConnectivity half_edges = half_edges_at(is_to_do, cut);
    std::vector<BoundaryLoop> loops;
    for (std::size_t k = 0; k < is_to_do.size(); ++k) {
        if (!is_to_do[k])
            continue;
        const auto loop = loop_through(
            OpenMesh::VertexHandle{static_cast<std::int32_t>(k)}, half_edges);
        for (const std::int32_t point : loop)
            is_to_do[point] = false;
        loops.push_back(in_mesh(loop, mesh, pieces));
    }
    std::ranges::stable_sort(
        loops, {}, [](const BoundaryLoop& loop) { return loop.points.front(); });
    return loops;
}

}  // namespace endmill
