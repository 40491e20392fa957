// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/mesh_topology.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <span>
#include <string>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "endmill/core/detail/disjoint_sets.h"
#include "endmill/core/error.h"
#include "endmill/mesh/detail/edge_uses.h"

namespace endmill {
namespace {

std::string name(const Edge& edge)
{
    return "edge " + std::to_string(edge[0]) + "-" + std::to_string(edge[1]);
}

void require_three_corners(const TriangleMesh& mesh)
{
    const auto bad = std::ranges::find_if(mesh.triangles(), repeats_a_corner);
    if (bad != mesh.triangles().end())
        throw GeometryError{"MeshTopology: triangle " +
                            std::to_string(bad - mesh.triangles().begin()) +
                            " repeats a corner"};
}

void require_manifold_edges(const EdgeUses& edges)
{
    edges.for_each([](const Edge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() > 2)
            throw GeometryError{"MeshTopology: " + name(edge) + " belongs to " +
                                std::to_string(uses.size()) + " triangles"};
        if (uses.size() == 2 && uses[0].is_forward() == uses[1].is_forward())
            throw GeometryError{"MeshTopology: both triangles of " + name(edge) +
                                " run along it in the same direction"};
    });
}

std::int32_t corner_at(const TriangleMesh& mesh, std::int32_t triangle,
                       std::int32_t point)
{
    const Triangle& corners = mesh.triangles()[triangle];
    return static_cast<std::int32_t>(std::ranges::find(corners, point) - corners.begin());
}

// Corners hang together across the edges at their point; a point must have one such fan.
void require_manifold_points(const TriangleMesh& mesh, const EdgeUses& edges)
{
    std::vector<std::int32_t> fan_of_point(mesh.points().size(), -1);
    DisjointSets fans{3 * mesh.triangles().size()};
    edges.for_each([&](const Edge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() != 2)
            return;
        const std::int32_t a = uses[0].triangle();
        const std::int32_t b = uses[1].triangle();
        for (const std::int32_t end : edge)
            fans.join(3 * a + corner_at(mesh, a, end), 3 * b + corner_at(mesh, b, end));
    });
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::int32_t point = mesh.triangles()[k][corner];
            const auto fan = fans.least(static_cast<std::int32_t>(3 * k + corner));
            if (fan_of_point[point] == -1)
                fan_of_point[point] = fan;
            if (fan_of_point[point] != fan)
                throw GeometryError{"MeshTopology: at point " + std::to_string(point) +
                                    " triangles meet that no edge there joins"};
        }
}

}  // namespace

struct MeshTopology::HalfEdges : OpenMesh::TriConnectivity {
    explicit HalfEdges(const TriangleMesh& mesh)
    {
        const std::size_t points = mesh.points().size();
        const std::size_t triangles = mesh.triangles().size();
        reserve(points, 3 * triangles / 2, triangles);
        for (std::size_t k = 0; k < points; ++k)
            new_vertex();
        for (const auto& [a, b, c] : mesh.triangles()) {
            const OpenMesh::VertexHandle corners[] = {vertex(a), vertex(b), vertex(c)};
            [[maybe_unused]] const auto face = add_face(corners, 3);
            assert(face.is_valid());
        }
    }

    static OpenMesh::VertexHandle vertex(std::int32_t number)
    {
        return OpenMesh::VertexHandle{number};
    }
};

MeshTopology::MeshTopology(const TriangleMesh& mesh)
{
    constexpr std::size_t most_corners = std::numeric_limits<std::int32_t>::max();
    require(mesh.triangles().size() <= most_corners / 3,
            "MeshTopology: at most 715 827 882 triangles");
    require_three_corners(mesh);
    const EdgeUses edges{mesh};
    require_manifold_edges(edges);
    require_manifold_points(mesh, edges);
    omlog().disable();
    omerr().disable();
    half_edges_ = std::make_shared<const HalfEdges>(mesh);
}

std::array<std::optional<std::size_t>, 3> MeshTopology::neighbours(
    std::size_t triangle) const
{
    require(triangle < half_edges_->n_faces(), "MeshTopology: there is no such triangle");
    std::array<std::optional<std::size_t>, 3> beyond;
    // A face's half-edge need not be that of its first side: OpenMesh keeps the last.
    auto side = half_edges_->halfedge_handle(
        OpenMesh::FaceHandle{static_cast<std::int32_t>(triangle)});
    side = half_edges_->next_halfedge_handle(side);
    for (auto& neighbour : beyond) {
        const auto face = half_edges_->opposite_face_handle(side);
        if (face.is_valid())
            neighbour = static_cast<std::size_t>(face.idx());
        side = half_edges_->next_halfedge_handle(side);
    }
    return beyond;
}

std::vector<std::int32_t> MeshTopology::one_ring(std::int32_t point) const
{
    require(0 <= point && static_cast<std::size_t>(point) < half_edges_->n_vertices(),
            "MeshTopology: there is no such point");
    // OpenMesh begins at the half-edge along which a hole is on the left, so that
    // clockwise it ends at the hole's other side.
    std::vector<std::int32_t> ring;
    const OpenMesh::VertexHandle centre = HalfEdges::vertex(point);
    for (auto at = half_edges_->cvv_cwbegin(centre); at != half_edges_->cvv_cwend(centre);
         ++at)
        ring.push_back(at->idx());
    std::ranges::reverse(ring);
    if (!ring.empty() && !half_edges_->is_boundary(centre))
        std::rotate(ring.begin(), std::ranges::min_element(ring), ring.end());
    return ring;
}

std::vector<std::vector<std::int32_t>> MeshTopology::boundary_loops() const
{
    const HalfEdges& mesh = *half_edges_;
    std::vector<std::vector<std::int32_t>> loops;
    std::vector<bool> seen(mesh.n_vertices(), false);
    for (std::size_t k = 0; k < mesh.n_vertices(); ++k) {
        const auto start = HalfEdges::vertex(static_cast<std::int32_t>(k));
        if (seen[k] || mesh.is_isolated(start) || !mesh.is_boundary(start))
            continue;
        // Boundary half-edges run against the triangles, and one by one backwards along
        // them; a point has only one.
        std::vector<std::int32_t>& loop = loops.emplace_back();
        auto side = mesh.halfedge_handle(start);
        do {
            const std::int32_t point = mesh.from_vertex_handle(side).idx();
            seen[point] = true;
            loop.push_back(point);
            side = mesh.prev_halfedge_handle(side);
        } while (mesh.from_vertex_handle(side) != start);
    }
    return loops;
}

MeshComponents MeshTopology::components() const
{
    const HalfEdges& mesh = *half_edges_;
    MeshComponents found{0, std::vector<std::int32_t>(mesh.n_faces(), -1)};
    std::vector<std::size_t> waiting;
    for (std::size_t first = 0; first < mesh.n_faces(); ++first) {
        if (found.of_triangle[first] >= 0)
            continue;
        const auto piece = static_cast<std::int32_t>(found.count++);
        found.of_triangle[first] = piece;
        waiting.push_back(first);
        while (!waiting.empty()) {
            const std::size_t triangle = waiting.back();
            waiting.pop_back();
            for (const auto& beyond : neighbours(triangle))
                if (beyond && found.of_triangle[*beyond] < 0) {
                    found.of_triangle[*beyond] = piece;
                    waiting.push_back(*beyond);
                }
        }
    }
    return found;
}

}  // namespace endmill
