// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/mesh_cover.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/bound/detail/boundary_in_triangle.h"

namespace endmill {
namespace {

// Most pieces of divided facets, about.
constexpr double most_pieces = 1e6;
// Cosine of the angle of a crease.
constexpr double crease_cosine = std::numbers::sqrt3 / 2;
// Least |grad Phi|. Where the tool touches the raised part a second time it is 0, and the inflow
// has no limit.
constexpr double least_gradient = 1e-6;
// Longest arc that is one flow.
constexpr double longest_arc = std::numbers::pi / 24;

double longest_edge_of(const std::array<Vec3, 3>& corners)
{
    return std::max({(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(),
                     (corners[0] - corners[2]).norm()});
}

// About how many pieces a facet is divided into.
double expected_pieces(const std::array<Vec3, 3>& corners, double longest_edge)
{
    const double length = longest_edge_of(corners);
    const double height =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / length;
    return std::max(1.0, 2 * length / longest_edge) *
           std::max(1.0, 2 * height / longest_edge);
}

double angle_at(const TriangleMesh& mesh, std::uint32_t facet, std::int32_t point)
{
    const Triangle& triangle = mesh.triangles()[facet];
    const std::size_t at = triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
    const Vec3 origin = mesh.points()[point];
    const Vec3 a = mesh.points()[triangle[(at + 1) % 3]] - origin;
    const Vec3 b = mesh.points()[triangle[(at + 2) % 3]] - origin;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3 corner_normal(const TriangleMesh& mesh, const std::vector<std::uint32_t>& around,
                   std::int32_t point, const Vec3& of_facet)
{
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t facet : around) {
        const Vec3 normal = facet_normal(mesh, facet);
        if (!is_crease(normal, of_facet))
            sum += angle_at(mesh, facet, point) * normal;
    }
    const double length = sum.norm();
    return length > 0 ? Vec3{sum / length} : of_facet;
}

// Halves a piece at its longest edge until none exceeds the limit.
void divide(const FacetPiece& piece, double longest_edge, std::vector<FacetPiece>& pieces)
{
    std::vector<FacetPiece> open{piece};
    while (!open.empty()) {
        FacetPiece last = open.back();
        open.pop_back();
        std::size_t longest = 0;
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double of_edge = (last.corners[(k + 1) % 3] - last.corners[k]).norm();
            if (of_edge > length)
                std::tie(longest, length) = std::pair{k, of_edge};
        }
        if (!(length > longest_edge)) {
            pieces.push_back(last);
            continue;
        }
        const std::size_t next = (longest + 1) % 3;
        const Vec3 middle = (last.corners[longest] + last.corners[next]) / 2;
        const Vec3 normal = (last.normals[longest] + last.normals[next]).normalized();
        FacetPiece other = last;
        std::tie(last.corners[next], last.normals[next]) = std::pair{middle, normal};
        std::tie(other.corners[longest], other.normals[longest]) =
            std::pair{middle, normal};
        open.push_back(last);
        open.push_back(other);
    }
}

Vec3 across(const Vec3& direction, const Vec3& normal)
{
    return direction - direction.dot(normal) * normal;
}

// An end of an arc of the boundary.
struct ArcEnd {
    Vec3 point;   // of the part
    Vec3 away;    // e: unit, from the tool to the raised place
    Vec3 normal;  // of the smooth part, about of length 1
};

// |grad Phi| on the smooth part. Along two edges of the triangle, taken across the normal, the
// raised place changes by them and by h times the change of the normal.
double gradient_of(const RaisedTriangle& triangle, const Vec3& normal, double height,
                   const Vec3& away)
{
    const Vec3 u = across(triangle.corners[1] - triangle.corners[0], normal);
    const Vec3 v = across(triangle.corners[2] - triangle.corners[0], normal);
    const double area = u.cross(v).norm();
    if (!(area > 0))
        return 0;
    const double slope_u =
        away.dot(u + height * across(triangle.normals[1] - triangle.normals[0], normal));
    const double slope_v =
        away.dot(v + height * across(triangle.normals[2] - triangle.normals[0], normal));
    return (slope_u * v - slope_v * u).norm() / area;
}

}  // namespace

double FacetPiece::area() const
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
}

Vec3 facet_normal(const TriangleMesh& mesh, std::size_t facet)
{
    const auto [a, b, c] = mesh.corners(facet);
    const Vec3 product = (b - a).cross(c - a);
    const double length = product.norm();
    return length > 0 ? Vec3{product / length} : Vec3{Vec3::Zero()};
}

bool is_crease(const Vec3& normal, const Vec3& other)
{
    return normal.dot(other) < crease_cosine;
}

std::vector<std::vector<std::uint32_t>> facets_at_points(const TriangleMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> facets(mesh.points().size());
    for (std::uint32_t k = 0; k < mesh.triangles().size(); ++k)
        for (const std::int32_t point : mesh.triangles()[k])
            facets[point].push_back(k);
    return facets;
}

std::vector<FacetPiece> facet_pieces(
    const TriangleMesh& mesh, const std::vector<std::vector<std::uint32_t>>& facets_at,
    double longest_edge)
{
    std::vector<FacetPiece> facing;
    for (std::uint32_t k = 0; k < mesh.triangles().size(); ++k) {
        const Vec3 normal = facet_normal(mesh, k);
        if (!(normal.z() > 0))
            continue;
        FacetPiece piece{mesh.corners(k), {}, k};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::int32_t point = mesh.triangles()[k][corner];
            piece.normals[corner] = corner_normal(mesh, facets_at[point], point, normal);
        }
        facing.push_back(piece);
    }
    const auto expected = [&](double longest) {
        double sum = 0;
        for (const FacetPiece& facet : facing)
            sum += expected_pieces(facet.corners, longest);
        return sum;
    };
    const double limit = std::max(most_pieces, 2 * static_cast<double>(facing.size()));
    while (expected(longest_edge) > limit)
        longest_edge *= 2;
    std::vector<FacetPiece> pieces;
    for (const FacetPiece& facet : facing)
        divide(facet, longest_edge, pieces);
    return pieces;
}

MeshCover::MeshCover(const std::vector<FacetPiece>& pieces, const BoundProblem& problem)
    : pieces_{pieces},
      problem_{problem},
      bins_{raised(pieces, problem.scallop_height),
            problem.cutter.radius() + problem.stray}
{
}

std::vector<MeshCover::Raised> MeshCover::raised(const std::vector<FacetPiece>& pieces,
                                                 double height)
{
    std::vector<Raised> all;
    all.reserve(pieces.size());
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
        std::array<Vec3, 3> corners;
        for (std::size_t at = 0; at < 3; ++at)
            corners[at] = pieces[k].corners[at] + height * pieces[k].normals[at];
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        double size = 0;
        for (const Vec3& corner : corners)
            size = std::max(size, (corner - middle).norm());
        all.push_back({middle, size, corners, k});
    }
    return all;
}

// The share of a triangle in the tool, which is convex.
double MeshCover::covered_share(const ToolReach& tool, const std::array<Vec3, 3>& corners,
                                int divisions)
{
    const std::array<double, 3> excess{tool.excess(corners[0]), tool.excess(corners[1]),
                                       tool.excess(corners[2])};
    if (std::ranges::all_of(excess, [](double value) { return value <= 0; }))
        return 1;
    if (divisions == 0)
        return share_below(excess);
    const auto& [a, b, c] = corners;
    const Vec3 ab = (a + b) / 2;
    const Vec3 bc = (b + c) / 2;
    const Vec3 ca = (c + a) / 2;
    return (covered_share(tool, {a, ab, ca}, divisions - 1) +
            covered_share(tool, {ab, b, bc}, divisions - 1) +
            covered_share(tool, {ca, bc, c}, divisions - 1) +
            covered_share(tool, {ab, bc, ca}, divisions - 1)) /
           4;
}

// The boundary in a triangle of a piece. Neighbouring triangles have the same ends on their common
// edge, so that nothing is lost.
void MeshCover::add_arc(const ToolReach& tool, const RaisedTriangle& triangle,
                        std::vector<MeshFlow>& flows) const
{
    std::array<double, 3> excess{};
    for (std::size_t k = 0; k < 3; ++k)
        excess[k] = tool.excess(triangle.raised[k]);
    std::array<ArcEnd, 2> ends;
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
        const std::size_t next = (k + 1) % 3;
        if ((excess[k] > 0) == (excess[next] > 0))
            continue;
        const Vec3 along = triangle.raised[next] - triangle.raised[k];
        const double share = crossing_share(excess[k], excess[next], [&](double t) {
            return tool.excess(triangle.raised[k] + t * along);
        });
        ends[found++] = {
            triangle.corners[k] + share * (triangle.corners[next] - triangle.corners[k]),
            tool.from_nearest(triangle.raised[k] + share * along).normalized(),
            triangle.normals[k] + share * (triangle.normals[next] - triangle.normals[k])};
    }
    if (found < 2)
        return;
    const Vec3 normal = (ends[0].normal + ends[1].normal).normalized();
    const Vec3 a = across(ends[0].away, normal);
    const Vec3 b = across(ends[1].away, normal);
    const double h = problem_.scallop_height;
    const double gradient = (gradient_of(triangle, normal, h, ends[0].away) +
                             gradient_of(triangle, normal, h, ends[1].away)) /
                            2;
    if (!(gradient > least_gradient))
        return;
    // The integral of the part of e along the surface over an arc is that over its chord, with the
    // direction in the middle. A long arc is divided into parts with the same sum.
    const double length = across(ends[1].point - ends[0].point, normal).norm();
    const double upwards =
        length / gradient * (ends[0].away + ends[1].away).dot(normal) / 2;
    const double along = length / gradient * (a.norm() + b.norm()) / 2;
    const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
    const int parts = std::max(1, static_cast<int>(std::ceil(turn / longest_arc)));
    const double part = parts > 1 ? std::sin(turn / 2 / parts) / std::sin(turn / 2) : 1;
    const Vec3 middle = (a.normalized() + b.normalized()).normalized();
    const Vec3 ahead = across(b.normalized() - a.normalized(), middle).normalized();
    for (int k = 0; k < parts; ++k) {
        const double share = (k + 0.5) / parts;
        const double angle = (share - 0.5) * turn;
        flows.push_back(
            {ends[0].point + share * (ends[1].point - ends[0].point),
             part * along * (std::cos(angle) * middle + std::sin(angle) * ahead) +
                 upwards / parts * normal});
    }
}

std::vector<MeshFlow> MeshCover::boundary(const Vec3& centre) const
{
    const ToolReach tool{problem_, centre};
    std::vector<MeshFlow> flows;
    bins_.visit_boundary(tool, [&](std::uint32_t number) {
        const Raised& raised = bins_.items()[number];
        const FacetPiece& piece = pieces_[raised.piece];
        add_arc(tool, {piece.corners, raised.corners, piece.normals}, flows);
    });
    return flows;
}

}  // namespace endmill
