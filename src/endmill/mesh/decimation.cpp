// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/decimation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "endmill/mesh/detail/edge_uses.h"
#include "endmill/mesh/detail/manifold_pieces.h"

namespace endmill {
namespace {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;
using Quadric = OpenMesh::Geometry::Quadricd;
using OpenMesh::Vec3d;

// Cosine of the largest angle by which a collapse may turn a triangle. More would fold it
// over its neighbours.
constexpr double least_turn_cosine = 0.2;
// Weight of a squared edge length, times the length squared as an area, against the
// quadric error. It is small enough to decide only among collapses of a flat region,
// where it prefers short edges and so avoids long thin triangles.
constexpr double length_weight = 1e-6;

Vec3d area_vector(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
    return (b - a) % (c - a) / 2;
}

// The plane through `point` across `normal`, weighted by the area of `normal`.
Quadric weighted_plane(const Vec3d& point, const Vec3d& normal)
{
    const double area = normal.norm();
    if (!(area > 0))
        return Quadric{};
    const Vec3d unit = normal / area;
    Quadric plane{unit[0], unit[1], unit[2], -(unit | point)};
    plane *= area;
    return plane;
}

// Cost of a collapse, for OpenMesh's decimater.
class QuadricCost : public OpenMesh::Decimater::ModBaseT<HalfEdgeMesh> {
public:
    using Handle = OpenMesh::Decimater::ModHandleT<QuadricCost>;

    explicit QuadricCost(HalfEdgeMesh& mesh)
        : OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>{mesh, false}
    {
    }

    // The planes of the triangles at each vertex, and upright planes on boundary edges.
    void initialize() override
    {
        quadrics_.assign(mesh().n_vertices(), Quadric{});
        for (const auto face : mesh().faces()) {
            const auto [a, b, c] = corners(face);
            const Quadric plane = weighted_plane(
                mesh().point(a),
                area_vector(mesh().point(a), mesh().point(b), mesh().point(c)));
            for (const auto corner : {a, b, c})
                quadrics_[corner.idx()] += plane;
        }
        for (const auto edge : mesh().halfedges())
            if (!mesh().is_boundary(edge) &&
                mesh().is_boundary(mesh().opposite_halfedge_handle(edge)))
                add_boundary(edge);
    }

    // The decimater asks for all collapses of a vertex in a row and takes the cheapest.
    // The expensive test for turned triangles is left out for those that another one
    // undercuts.
    float collapse_priority(const CollapseInfo& collapse) override
    {
        if (collapse.v0 != vertex_) {
            vertex_ = collapse.v0;
            least_cost_ = std::numeric_limits<float>::infinity();
        }
        Quadric sum = quadrics_[collapse.v0.idx()];
        sum += quadrics_[collapse.v1.idx()];
        const double length2 = (collapse.p1 - collapse.p0).sqrnorm();
        const double cost = sum(collapse.p1) + length_weight * length2 * length2;
        // Rounding may make the cost negative.
        const auto priority = static_cast<float>(std::max(cost, 0.0));
        if (priority >= least_cost_ || turns_a_triangle(collapse))
            return ILLEGAL_COLLAPSE;
        least_cost_ = priority;
        return priority;
    }

    void postprocess_collapse(const CollapseInfo& collapse) override
    {
        quadrics_[collapse.v1.idx()] += quadrics_[collapse.v0.idx()];
        vertex_ = OpenMesh::VertexHandle{};
    }

private:
    using Vertices = std::array<OpenMesh::VertexHandle, 3>;

    Vertices corners(OpenMesh::FaceHandle face)
    {
        const auto side = mesh().halfedge_handle(face);
        const auto next = mesh().next_halfedge_handle(side);
        return {mesh().from_vertex_handle(side), mesh().to_vertex_handle(side),
                mesh().to_vertex_handle(next)};
    }

    void add_boundary(OpenMesh::HalfedgeHandle edge)
    {
        const auto [a, b, c] = corners(mesh().face_handle(edge));
        const Vec3d normal =
            area_vector(mesh().point(a), mesh().point(b), mesh().point(c));
        const auto from = mesh().from_vertex_handle(edge);
        const auto to = mesh().to_vertex_handle(edge);
        const Vec3d along = mesh().point(to) - mesh().point(from);
        const double area = normal.norm();
        if (!(area > 0))
            return;
        // As large as the square over the edge, so that the boundary weighs like a
        // surface.
        const Vec3d outwards = along % normal / area * along.norm();
        const Quadric plane = weighted_plane(mesh().point(from), outwards);
        quadrics_[from.idx()] += plane;
        quadrics_[to.idx()] += plane;
    }

    // Whether a triangle at v0 that stays turns too far, or loses its area.
    bool turns_a_triangle(const CollapseInfo& collapse)
    {
        for (const auto face : mesh().vf_range(collapse.v0)) {
            if (face == collapse.fl || face == collapse.fr)
                continue;
            const Vertices at = corners(face);
            const int own = at[0] == collapse.v0 ? 0 : at[1] == collapse.v0 ? 1 : 2;
            const Vec3d& next = mesh().point(at[(own + 1) % 3]);
            const Vec3d& last = mesh().point(at[(own + 2) % 3]);
            const Vec3d old_area = area_vector(collapse.p0, next, last);
            const Vec3d new_area = area_vector(collapse.p1, next, last);
            const double product = old_area | new_area;
            if (!(product > 0 &&
                  product * product > least_turn_cosine * least_turn_cosine *
                                          old_area.sqrnorm() * new_area.sqrnorm()))
                return true;
        }
        return false;
    }

    std::vector<Quadric> quadrics_;  // of each vertex
    OpenMesh::VertexHandle vertex_;  // whose collapses are being asked for
    float least_cost_ = 0;           // of them so far
};

// The pieces, moved and scaled into the unit cube: costs then fit into the floats in
// which OpenMesh keeps them, and lose no digits if the mesh is far from the origin.
HalfEdgeMesh half_edge_mesh(const TriangleMesh& mesh, const ManifoldPieces& pieces)
{
    omlog().disable();
    omerr().disable();
    Eigen::AlignedBox3d box;
    for (const std::int32_t number : pieces.points)
        box.extend(mesh.points()[number]);
    const double side = pieces.points.empty() ? 0 : box.sizes().maxCoeff();
    const double scale = side > 0 ? 1 / side : 1;
    HalfEdgeMesh result;
    result.reserve(pieces.points.size(), 3 * pieces.triangles.size() / 2,
                   pieces.triangles.size());
    for (const std::int32_t number : pieces.points) {
        const Vec3 point = scale * (mesh.points()[number] - box.min());
        result.add_vertex({point.x(), point.y(), point.z()});
    }
    for (const auto& [a, b, c] : pieces.triangles) {
        [[maybe_unused]] const auto face =
            result.add_face(OpenMesh::VertexHandle{a}, OpenMesh::VertexHandle{b},
                            OpenMesh::VertexHandle{c});
        assert(face.is_valid());
    }
    return result;
}

DecimatedMesh unchanged(const TriangleMesh& mesh)
{
    DecimatedMesh result{mesh, std::vector<std::int32_t>(mesh.points().size()),
                         std::vector<std::int32_t>(mesh.triangles().size())};
    std::iota(result.source_points.begin(), result.source_points.end(), 0);
    std::iota(result.source_triangles.begin(), result.source_triangles.end(), 0);
    return result;
}

// The mesh of `triangles`, given by the points of `mesh`, without the points that they do
// not use.
DecimatedMesh compacted(const TriangleMesh& mesh, std::vector<Triangle> triangles,
                        std::vector<std::int32_t> source_triangles)
{
    std::vector<std::int32_t> numbers(mesh.points().size(), -1);
    for (const Triangle& triangle : triangles)
        for (const std::int32_t corner : triangle)
            numbers[corner] = 0;
    std::vector<Vec3> points;
    std::vector<std::int32_t> source_points;
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (numbers[k] == 0) {
            numbers[k] = static_cast<std::int32_t>(points.size());
            points.push_back(mesh.points()[k]);
            source_points.push_back(static_cast<std::int32_t>(k));
        }
    for (Triangle& triangle : triangles)
        for (std::int32_t& corner : triangle)
            corner = numbers[corner];
    return {TriangleMesh{std::move(points), std::move(triangles)},
            std::move(source_points), std::move(source_triangles)};
}

}  // namespace

// OpenMesh keeps the triangles that a collapse leaves under their old numbers, with other
// corners: a remaining triangle replaces the given one of its number.
DecimatedMesh decimated(const TriangleMesh& mesh, std::size_t most_triangles)
{
    if (mesh.triangles().size() <= most_triangles)
        return unchanged(mesh);
    const ManifoldPieces pieces = manifold_pieces(mesh);
    HalfEdgeMesh coarse = half_edge_mesh(mesh, pieces);
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater{coarse};
    QuadricCost::Handle cost;
    decimater.add(cost);
    decimater.initialize();
    decimater.decimate_to_faces(0, most_triangles);
    std::vector<Triangle> triangles;
    std::vector<std::int32_t> source_triangles;
    for (const auto face : coarse.all_faces()) {
        if (coarse.status(face).deleted())
            continue;
        Triangle corners{};
        std::size_t k = 0;
        for (const auto corner : coarse.fv_range(face))
            corners[k++] = pieces.points[corner.idx()];
        if (repeats_a_corner(corners))  // it has two copies of one point
            continue;
        triangles.push_back(corners);
        source_triangles.push_back(pieces.source_triangles[face.idx()]);
    }
    return compacted(mesh, std::move(triangles), std::move(source_triangles));
}

}  // namespace endmill
