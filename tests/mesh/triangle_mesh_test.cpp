// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_mesh.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(TriangleMesh, IsEmptyUnlessItIsGivenTriangles)
{
    const TriangleMesh mesh;
    EXPECT_TRUE(mesh.points().empty());
    EXPECT_TRUE(mesh.triangles().empty());
}

TEST(TriangleMesh, HasTheCornersOfItsNumbers)
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, {{2, 0, 1}}};
    const auto [a, b, c] = mesh.corners(0);
    EXPECT_EQ(a, Vec3(0, 1, 0));
    EXPECT_EQ(b, Vec3(0, 0, 0));
    EXPECT_EQ(c, Vec3(1, 0, 0));
}

TEST(TriangleMesh, RefusesInvalidNumbersAndPoints)
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_THROW(TriangleMesh(points, {{0, 1, 3}}), DomainError);
    EXPECT_THROW(TriangleMesh(points, {{0, 1, -1}}), DomainError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(TriangleMesh({{0, nan, 0}}, {}), DomainError);
}

}  // namespace
}  // namespace endmill
