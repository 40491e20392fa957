// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/mesh_net.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/mesh/decimation.h"
#include "endmill/mesh/detail/weld.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {
namespace {

// A facet is a wall or faces the tool if the z of its unit normal is above this; the module
// deviation judges the same facets.
constexpr double least_normal_z = -1e-9;
// Points that are nearer than this are joined: mm, and a share of the largest coordinate,
// which is the rounding of binary STL files.
constexpr double crack = 1e-6;
constexpr double crack_share = 2e-7;
// A mesh is made coarser if it has this many times the needed triangles, and more than the
// second number.
constexpr double fine_factor = 4;
constexpr std::size_t few_triangles = 20'000;
// Largest turn of the normal across one triangle of a strip, rad.
constexpr double strip_turn = 0.55;

Vec3 area_vector(const std::array<Vec3, 3>& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
}

// The facets that face the tool, with nearly equal points joined.
TriangleMesh facing_facets(const TriangleMesh& mesh)
{
    double largest = 0;
    for (const Vec3& point : mesh.points())
        largest = std::max(largest, point.cwiseAbs().maxCoeff());
    TriangleMesh joined = weld(mesh, std::max(crack, crack_share * largest)).mesh;
    std::vector<Triangle> facing;
    for (std::size_t k = 0; k < joined.triangles().size(); ++k) {
        const Vec3 area = area_vector(joined.corners(k));
        if (area.norm() > 0 && area.z() >= least_normal_z * area.norm())
            facing.push_back(joined.triangles()[k]);
    }
    if (facing.empty()) {
        if (joined.triangles().empty())
            throw GeometryError{"the mesh has no triangle"};
        const auto [a, b, c] = joined.corners(0);
        const Vec3 middle = (a + b + c) / 3;
        throw GeometryError{"no facet of the mesh faces the tool: N . axis <= 0 at " +
                            place_text({middle.x(), middle.y()}, middle) +
                            " and everywhere else"};
    }
    return {{joined.points().begin(), joined.points().end()}, std::move(facing)};
}

double area_of(const TriangleMesh& mesh)
{
    double area = 0;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        area += area_vector(mesh.corners(k)).norm();
    return area;
}

double angle_at(const std::array<Vec3, 3>& corners, int k)
{
    const Vec3 a = corners[(k + 1) % 3] - corners[k];
    const Vec3 b = corners[(k + 2) % 3] - corners[k];
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double angle_between(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The means of the normals of the facets at each point, weighted by their angles.
std::vector<Vec3> mean_normals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.points().size(), Vec3::Zero());
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
        const std::array<Vec3, 3> corners = mesh.corners(t);
        const Vec3 normal = area_vector(corners).normalized();
        for (int k = 0; k < 3; ++k)
            normals[mesh.triangles()[t][k]] += angle_at(corners, k) * normal;
    }
    return normals;
}

// A corner of a triangle, as 3 t + k.
using CornerNumber = std::int32_t;

// Sets of corners that share a normal.
class CornerGroups {
public:
    explicit CornerGroups(std::size_t corners) : parent_(corners)
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    CornerNumber root(CornerNumber corner)
    {
        while (parent_[corner] != corner)
            corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }

    void unite(CornerNumber a, CornerNumber b)
    {
        const CornerNumber first = root(a);
        const CornerNumber second = root(b);
        parent_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<CornerNumber> parent_;
};

// An edge with a turn of the normal, by the corners of its triangles at both of its ends.
struct Crease {
    std::array<CornerNumber, 2> first;   // in the first triangle
    std::array<CornerNumber, 2> second;  // at the same ends, in the second triangle
    double turn;                         // rad
};

CornerNumber corner_number(std::size_t triangle, int k)
{
    return static_cast<CornerNumber>(3 * triangle + static_cast<std::size_t>(k % 3));
}

// Unites the corners across edges with a small turn and returns the others. An edge of one
// triangle, of more than two, or between triangles of opposite orientation is a border.
// \param smoothed_turn becomes the greatest turn of an edge across which corners are united.
std::vector<Crease> unite_smooth_corners(const TriangleMesh& mesh, double smooth_turn,
                                         CornerGroups& groups, double& smoothed_turn)
{
    struct Use {
        std::int32_t low;
        std::int32_t high;
        CornerNumber from;  // the corner at which the triangle enters the edge
        bool is_forward;
    };
    std::vector<Use> uses;
    const std::span<const Triangle> triangles = mesh.triangles();
    uses.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            uses.push_back({low, high, corner_number(t, k), low == triangles[t][k]});
        }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return std::array{a.low, a.high, a.from} < std::array{b.low, b.high, b.from};
    });
    const auto normal = [&](CornerNumber corner) {
        return area_vector(mesh.corners(static_cast<std::size_t>(corner) / 3))
            .normalized();
    };
    const auto to = [](CornerNumber from) {
        return corner_number(static_cast<std::size_t>(from) / 3, from % 3 + 1);
    };
    std::vector<Crease> creases;
    for (std::size_t k = 0, next = 0; k < uses.size(); k = next) {
        while (next < uses.size() && uses[next].low == uses[k].low &&
               uses[next].high == uses[k].high)
            ++next;
        if (next != k + 2 || uses[k].is_forward == uses[k + 1].is_forward)
            continue;
        const CornerNumber a = uses[k].from;
        const CornerNumber b = uses[k + 1].from;
        const double turn = angle_between(normal(a), normal(b));
        if (turn <= smooth_turn) {
            smoothed_turn = std::max(smoothed_turn, turn);
            groups.unite(a, to(b));
            groups.unite(to(a), b);
        } else {
            creases.push_back({{a, to(a)}, {to(b), b}, turn});
        }
    }
    return creases;
}

// Joins both sides of sharp edges by strips of triangles without area.
class CreaseStrips {
public:
    explicit CreaseStrips(MeshNet& net) : net_{&net} {}

    // A strip along an edge from (a, b) of one side to (c, d) of the other.
    void add(const std::array<std::int32_t, 2>& one,
             const std::array<std::int32_t, 2>& other)
    {
        const double turn = std::max(angle(one[0], other[0]), angle(one[1], other[1]));
        const int steps = std::max(1, static_cast<int>(std::ceil(turn / strip_turn)));
        const std::vector<std::int32_t> a = chain(one[0], other[0], steps);
        const std::vector<std::int32_t> b = chain(one[1], other[1], steps);
        for (std::size_t k = 0; k < std::max(a.size(), b.size()) - 1; ++k) {
            const auto at = [&](const std::vector<std::int32_t>& end, std::size_t step) {
                return end[std::min(step, end.size() - 1)];
            };
            add_triangle({at(a, k + 1), at(b, k + 1), at(b, k)});
            add_triangle({at(a, k + 1), at(b, k), at(a, k)});
        }
    }

    // Closes the gap between three or more strips that meet in a point.
    void close_corners()
    {
        std::map<std::array<double, 3>, std::vector<std::vector<std::int32_t>>> at_points;
        for (const auto& [ends, chain] : chains_)
            if (chain.size() > 1) {
                const Vec3& p = net_->points[chain.front()];
                at_points[{p.x(), p.y(), p.z()}].push_back(chain);
            }
        for (const auto& [place, chains] : at_points)
            if (chains.size() > 2)
                close(chains);
    }

private:
    double angle(std::int32_t a, std::int32_t b) const
    {
        return angle_between(net_->normals[a], net_->normals[b]);
    }

    // The samples from a to b, whose normals turn from one to the other. A chain is made
    // once, by the first edge at it.
    std::vector<std::int32_t> chain(std::int32_t a, std::int32_t b, int steps)
    {
        if (a == b)
            return {a};
        std::vector<std::int32_t>& known = chains_[std::minmax(a, b)];
        if (known.empty()) {
            const auto [low, high] = std::minmax(a, b);
            known.push_back(low);
            for (int step = 1; step < steps; ++step)
                known.push_back(add_sample(net_->points[low],
                                           between(low, high, step / double(steps))));
            known.push_back(high);
        }
        if (known.front() == a)
            return known;
        return {known.rbegin(), known.rend()};
    }

    Vec3 between(std::int32_t a, std::int32_t b, double share) const
    {
        const double turn = angle(a, b);
        const Vec3 sum = std::sin((1 - share) * turn) * net_->normals[a] +
                         std::sin(share * turn) * net_->normals[b];
        // opposite normals turn over the top
        return sum.norm() > 1e-6 ? sum.normalized() : Vec3::UnitZ();
    }

    void close(const std::vector<std::vector<std::int32_t>>& chains)
    {
        Vec3 sum = Vec3::Zero();
        for (const std::vector<std::int32_t>& chain : chains)
            sum += net_->normals[chain.front()] + net_->normals[chain.back()];
        if (sum.norm() <= 1e-6)
            return;
        const std::int32_t middle =
            add_sample(net_->points[chains.front().front()], sum.normalized());
        for (const std::vector<std::int32_t>& chain : chains)
            for (std::size_t k = 0; k + 1 < chain.size(); ++k)
                add_triangle({middle, chain[k], chain[k + 1]});
    }

    std::int32_t add_sample(const Vec3& point, const Vec3& normal)
    {
        net_->points.push_back(point);
        net_->normals.push_back(normal);
        return static_cast<std::int32_t>(net_->points.size() - 1);
    }

    void add_triangle(const Triangle& triangle)
    {
        const auto& [a, b, c] = triangle;
        if (a != b && b != c && c != a)
            net_->triangles.push_back(triangle);
    }

    MeshNet* net_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> chains_;
};

// The net of facets, with the sides of sharp edges apart and joined by strips.
// \param smooth_normals a direction at each point; it counts where no sharp edge ends.
MeshNet net_of(const TriangleMesh& mesh, const MeshNetLimits& limits,
               std::span<const Vec3> smooth_normals)
{
    const std::span<const Triangle> triangles = mesh.triangles();
    CornerGroups groups{3 * triangles.size()};
    MeshNet net;
    std::vector<Crease> creases =
        unite_smooth_corners(mesh, limits.smooth_mesh_turn, groups, net.smoothed_turn);
    if (!creases.empty()) {
        groups = CornerGroups{3 * triangles.size()};
        net.smoothed_turn = 0;
        creases =
            unite_smooth_corners(mesh, limits.smooth_turn, groups, net.smoothed_turn);
    }
    net.has_creases =
        std::any_of(creases.begin(), creases.end(),
                    [](const Crease& crease) { return crease.turn > crease_angle; });
    std::vector<std::int32_t> sample_of(3 * triangles.size(), -1);
    std::vector<std::int32_t> point_of;
    std::vector<int> samples_at(mesh.points().size(), 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::array<Vec3, 3> corners = mesh.corners(t);
        const Vec3 normal = area_vector(corners).normalized();
        Triangle& own = net.triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            std::int32_t& sample = sample_of[groups.root(corner_number(t, k))];
            if (sample < 0) {
                sample = static_cast<std::int32_t>(net.points.size());
                net.points.push_back(corners[k]);
                net.normals.push_back(Vec3::Zero());
                point_of.push_back(triangles[t][k]);
                ++samples_at[triangles[t][k]];
            }
            net.normals[sample] += angle_at(corners, k) * normal;
            own[k] = sample;
        }
    }
    for (std::size_t i = 0; i < net.normals.size(); ++i) {
        const Vec3& smooth = smooth_normals[point_of[i]];
        if (samples_at[point_of[i]] == 1 && smooth.norm() > 0)
            net.normals[i] = smooth;
        net.normals[i].normalize();
    }
    CreaseStrips strips{net};
    const auto sample = [&](CornerNumber corner) {
        return sample_of[groups.root(corner)];
    };
    for (const auto& [first, second, turn] : creases)
        strips.add({sample(first[0]), sample(first[1])},
                   {sample(second[0]), sample(second[1])});
    strips.close_corners();
    return net;
}

}  // namespace

MeshNet mesh_net(const TriangleMesh& mesh, const MeshNetLimits& limits)
{
    const double spacing = limits.spacing;
    const TriangleMesh facing = facing_facets(mesh);
    const std::vector<Vec3> normals = mean_normals(facing);
    // a triangle with three sides of the spacing
    const double needed = area_of(facing) / (std::sqrt(3.0) / 4 * spacing * spacing);
    const auto count = static_cast<double>(facing.triangles().size());
    if (facing.triangles().size() <= few_triangles || count <= fine_factor * needed)
        return net_of(facing, limits, normals);
    const DecimatedMesh coarse = decimated(
        facing, std::max(few_triangles, static_cast<std::size_t>(std::ceil(needed))));
    std::vector<Vec3> own(coarse.source_points.size());
    for (std::size_t k = 0; k < own.size(); ++k)
        own[k] = normals[coarse.source_points[k]];
    MeshNet net = net_of(coarse.mesh, {spacing, crease_angle, crease_angle}, own);
    net.is_coarser = true;
    net.smoothed_turn = 0;
    return net;
}

}  // namespace endmill
