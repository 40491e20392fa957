// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/mesh_segments.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "grid_mesh.h"
#include "random.h"

namespace endmill {
namespace {

// Tests every triangle with every plane.
TEST(MeshSegments, AreThoseOfTrianglesWithVerticesOnBothSides)
{
    test::Random random{11};
    const auto mesh = test::grid_mesh(30, 30, [&](int i, int j) {
        return Vec3{i + random.uniform(-1, 1), j + random.uniform(-1, 1),
                    random.uniform(-1, 1)};
    });
    const DriveFrame frame{Angle::degrees(40)};
    // Uneven distances, two equal positions, and one plane through a vertex.
    std::vector<double> positions{-5, -4.99, -1, 0, 0, 3, 17, 100};
    positions[6] = frame.across(mesh.points()[600]);
    std::ranges::sort(positions);
    const MeshSegments segments = mesh_segments(mesh, frame, positions);
    ASSERT_EQ(segments.first.size(), positions.size() + 1);
    for (std::size_t plane = 0; plane < positions.size(); ++plane) {
        std::size_t next = segments.first[plane];
        for (std::int32_t k = 0; k < std::ssize(mesh.triangles()); ++k) {
            int above = 0;
            for (const int vertex : mesh.triangles()[k])
                above += frame.across(mesh.points()[vertex]) > positions[plane] ? 1 : 0;
            if (above == 0 || above == 3)
                continue;
            ASSERT_LT(next, segments.first[plane + 1]);
            EXPECT_EQ(segments.triangle[next], k);
            ++next;
        }
        EXPECT_EQ(next, segments.first[plane + 1]);
    }
}

// The outer side of level triangles faces up and is on the left of a segment towards
// larger s. All six ways in which a plane separates the corners occur.
TEST(MeshSegments, HaveTheOuterSideOnTheirLeft)
{
    const DriveFrame frame{Angle::degrees(0)};
    for (int first = 0; first < 3; ++first)
        for (const double up : {1.0, -1.0}) {
            const std::vector<Vec3> points{{0, up, 0}, {-up, -up, 0}, {up, -up, 0}};
            const TriangleMesh mesh{points, {{first, (first + 1) % 3, (first + 2) % 3}}};
            const std::vector<double> positions{0};
            const MeshSegments segments = mesh_segments(mesh, frame, positions);
            ASSERT_EQ(segments.from.size(), 1U);
            EXPECT_EQ(point_on(segments.from[0], points, frame, 0).x(), -0.5);
            EXPECT_EQ(point_on(segments.to[0], points, frame, 0).x(), 0.5);
        }
}

TEST(MeshSegments, OfNoTrianglesAreNone)
{
    const std::vector<double> positions{0, 1};
    const auto segments =
        mesh_segments(TriangleMesh{}, DriveFrame{Angle::degrees(0)}, positions);
    EXPECT_TRUE(segments.from.empty());
    EXPECT_EQ(segments.first, (std::vector<std::size_t>{0, 0, 0}));
}

}  // namespace
}  // namespace endmill
