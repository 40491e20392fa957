// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/place_order.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

TriangleMesh shuffled(const TriangleMesh& mesh)
{
    std::vector<Triangle> triangles = test::triangles_of(mesh);
    std::ranges::shuffle(triangles, test::Random{1}.engine());
    return {test::points_of(mesh), std::move(triangles)};
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles)
{
    std::ranges::sort(triangles);
    return triangles;
}

// The triangles by the numbers of the mesh.
std::vector<Triangle> in_mesh(const TrianglesByPlace& by_place)
{
    std::vector<Triangle> triangles = by_place.triangles;
    for (Triangle& triangle : triangles)
        for (std::int32_t& corner : triangle)
            corner = by_place.points[corner];
    return triangles;
}

TEST(TrianglesByPlace, AreThoseOfTheMesh)
{
    for (const TriangleMesh& mesh :
         {test::torus_mesh(30, 20), test::flat_mesh(1, 1), test::flat_mesh(200, 3)}) {
        const TriangleMesh mixed = shuffled(mesh);
        const TrianglesByPlace by_place = triangles_by_place(mixed);
        EXPECT_EQ(sorted(in_mesh(by_place)), sorted(test::triangles_of(mesh)));
        const std::set<std::int32_t> used(by_place.points.begin(), by_place.points.end());
        EXPECT_EQ(used.size(), mesh.points().size());
    }
}

TEST(TrianglesByPlace, LeaveOutPointsThatNoTriangleUses)
{
    const std::vector<Vec3> points{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}};
    const TrianglesByPlace by_place = triangles_by_place({points, {{4, 1, 2}}});
    EXPECT_EQ(by_place.points, (std::vector<std::int32_t>{4, 1, 2}));
    EXPECT_TRUE(triangles_by_place(TriangleMesh{}).triangles.empty());
}

TEST(TrianglesByPlace, AcceptPointsAtOnePlaceAndAtTheEndsOfTheNumbers)
{
    const Vec3 far = Vec3::Constant(1.7e308);
    for (const std::vector<Vec3>& points :
         {std::vector<Vec3>(3, Vec3{1, 2, 3}), {far, -far, Vec3{0, 0, 1e-308}}}) {
        const TrianglesByPlace by_place =
            triangles_by_place({points, {{0, 1, 2}, {1, 1, 0}}});
        EXPECT_EQ(sorted(in_mesh(by_place)),
                  (std::vector<Triangle>{{0, 1, 2}, {1, 1, 0}}));
    }
}

TEST(TrianglesByPlace, AreNoLongerScattered)
{
    const TriangleMesh mesh = test::torus_mesh(500, 400);
    EXPECT_FALSE(are_scattered(mesh));
    const TriangleMesh mixed = shuffled(mesh);
    EXPECT_TRUE(are_scattered(mixed));
    EXPECT_FALSE(
        are_scattered({test::points_of(mesh), triangles_by_place(mixed).triangles}));
    EXPECT_FALSE(are_scattered(shuffled(test::torus_mesh(50, 40)))) << "small";
}

}  // namespace
}  // namespace endmill
