// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/mesh_net.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/sample_net.h"
#include "test_meshes.h"

namespace endmill {
namespace {

double border_length(const MeshNet& net)
{
    std::vector<std::int32_t> own(net.points.size());
    std::iota(own.begin(), own.end(), 0);
    double sum = 0;
    for (const auto& [a, b] : net_border(net.triangles, own))
        sum += (net.points[a] - net.points[b]).norm();
    return sum;
}

double area(const MeshNet& net)
{
    double sum = 0;
    for (const auto& [a, b, c] : net.triangles)
        sum +=
            (net.points[b] - net.points[a]).cross(net.points[c] - net.points[a]).norm();
    return sum / 2;
}

// The underside is left out; strips join the top and the sides.
TEST(MeshNet, IsOneSheetOverTheFacetsOfABoxThatFaceTheTool)
{
    const MeshNet net = mesh_net(test::box_mesh({0, 0, 0}, {40, 30, 10}),
                                 {1, crease_angle, crease_angle});
    EXPECT_TRUE(net.has_creases);
    EXPECT_FALSE(net.is_coarser);
    EXPECT_NEAR(area(net), 40 * 30 + 2 * (40 + 30) * 10, 1e-9);
    EXPECT_NEAR(border_length(net), 2 * (40 + 30), 1e-9);
    for (const Vec3& normal : net.normals)
        EXPECT_NEAR(normal.norm(), 1, 1e-12);
}

// The centres of a ball around the edges of a box form one surface too: its parts are the
// raised facets, quarters of cylinders and, at the four upper corners, of a sphere.
TEST(MeshNet, TurnsTheNormalAroundSharpEdgesInSteps)
{
    const MeshNet net = mesh_net(test::box_mesh({0, 0, 0}, {40, 30, 10}),
                                 {1, crease_angle, crease_angle});
    double least = 1;
    for (const auto& [a, b, c] : net.triangles)
        for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
            least = std::min(least, net.normals[p].dot(net.normals[q]));
    EXPECT_GT(least, std::cos(1.0));
}

TEST(MeshNet, HasTheNormalsOfASmoothPart)
{
    const auto height = [](double x, double y) { return (x * x - y * y) / 60; };
    const TriangleMesh mesh = test::grid_mesh(40, 40, [&](int i, int j) {
        const double x = (i - 20) * 0.5;
        const double y = (j - 20) * 0.5;
        return Vec3{x, y, height(x, y)};
    });
    const MeshNet net = mesh_net(mesh, {0.5, crease_angle, crease_angle});
    EXPECT_FALSE(net.has_creases);
    for (std::size_t i = 0; i < net.points.size(); ++i) {
        const Vec3& p = net.points[i];
        const Vec3 normal = Vec3{-p.x() / 30, p.y() / 30, 1}.normalized();
        // facets at the border lie on one side only
        EXPECT_LT((net.normals[i] - normal).norm(), 0.012);
    }
}

// On a roof of two facets, every place of a facet has the normal of its facet, up to the
// border and the edge, if the turn of the edge exceeds the limit.
TEST(MeshNet, HasTheNormalsOfFacetsBesideEdgesThatTurnMoreThanTheLimit)
{
    const double rise = 0.1;
    const TriangleMesh roof{{{-4, 0, 0}, {0, -3, 4 * rise}, {0, 3, 4 * rise}, {4, 0, 0}},
                            {{0, 1, 2}, {3, 2, 1}}};
    const double turn = 2 * std::atan(rise);
    const MeshNet blunt = mesh_net(roof, {1, 1.01 * turn, 1.01 * turn});
    EXPECT_EQ(blunt.points.size(), 4u);
    EXPECT_NEAR(blunt.smoothed_turn, turn, 1e-9);
    const MeshNet of_smooth_mesh = mesh_net(roof, {1, 0.5 * turn, 1.01 * turn});
    EXPECT_EQ(of_smooth_mesh.points.size(), blunt.points.size());
    const MeshNet net = mesh_net(roof, {1, 0.99 * turn, 0.99 * turn});
    EXPECT_EQ(net.smoothed_turn, 0);
    EXPECT_FALSE(net.has_creases);
    EXPECT_NEAR(area(net), area(blunt), 1e-12);
    EXPECT_NEAR(border_length(net), border_length(blunt), 1e-12);
    for (const auto& [a, b, c] : net.triangles) {
        const Vec3 normal =
            (net.points[b] - net.points[a]).cross(net.points[c] - net.points[a]);
        if (normal.norm() == 0)
            continue;  // of the strip
        for (const std::int32_t corner : {a, b, c})
            EXPECT_LT((net.normals[corner] - normal.normalized()).norm(), 1e-12);
    }
}

TEST(MeshNet, ClosesHairCracks)
{
    const TriangleMesh left = test::flat_mesh(1, 1);
    std::vector<Vec3> moved = test::points_of(left);
    for (Vec3& point : moved)
        point.x() += 1 + 1e-7;
    const TriangleMesh mesh = test::both(left, {moved, test::triangles_of(left)});
    EXPECT_NEAR(border_length(mesh_net(mesh, {0.5, crease_angle, crease_angle})), 6,
                1e-6);
}

TEST(MeshNet, IsCoarserThanAFineMesh)
{
    const TriangleMesh mesh = test::grid_mesh(300, 300, [&](int i, int j) {
        return Vec3{0.1 * i, 0.1 * j, std::sin(0.02 * i) * std::cos(0.03 * j)};
    });
    const MeshNet net = mesh_net(mesh, {2, crease_angle, crease_angle});
    EXPECT_TRUE(net.is_coarser);
    EXPECT_LT(net.triangles.size(), 25'000u);
    const MeshNet exact = mesh_net(mesh, {0.1, crease_angle, crease_angle});
    EXPECT_FALSE(exact.is_coarser);
    EXPECT_NEAR(area(net), area(exact), 1e-3 * area(exact));
}

TEST(MeshNet, RefusesAMeshThatFacesDown)
{
    const TriangleMesh down =
        test::with_turned(test::flat_mesh(2, 2), [](std::size_t) { return true; });
    EXPECT_THROW(mesh_net(down, {1, crease_angle, crease_angle}), GeometryError);
}

}  // namespace
}  // namespace endmill
