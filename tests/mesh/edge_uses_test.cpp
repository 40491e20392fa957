// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/edge_uses.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

using Use = std::tuple<bool, std::int32_t>;  // backward, triangle

std::map<MeshEdge, std::vector<Use>> uses_by_map(const TriangleMesh& mesh)
{
    std::map<MeshEdge, std::vector<Use>> uses;
    std::int32_t number = 0;
    for (const Triangle& triangle : mesh.triangles()) {
        const std::set<std::int32_t> corners(triangle.begin(), triangle.end());
        for (int side = 0; side < 3 && corners.size() == 3; ++side) {
            const auto from = triangle[side];
            const auto to = triangle[(side + 1) % 3];
            uses[{std::min(from, to), std::max(from, to)}].emplace_back(from > to,
                                                                        number);
        }
        ++number;
    }
    for (auto& [edge, of_edge] : uses)
        std::ranges::sort(of_edge);
    return uses;
}

TriangleMesh random_triangles(test::Random& random, int points, int triangles)
{
    std::vector<Triangle> chosen(triangles);
    for (Triangle& triangle : chosen)
        for (std::int32_t& corner : triangle)
            corner = static_cast<std::int32_t>(random.uniform(0, points));
    return {std::vector<Vec3>(points, Vec3::Zero()), std::move(chosen)};
}

TEST(EdgeUses, EqualThoseOfAMapInOrder)
{
    test::Random random{1};
    for (const int points : {3, 5, 20, 400}) {
        const TriangleMesh mesh = random_triangles(random, points, 500);
        std::vector<std::pair<MeshEdge, std::vector<Use>>> found;
        EdgeUses{mesh}.for_each([&](const MeshEdge& edge, std::span<const EdgeUse> uses) {
            found.emplace_back(edge, std::vector<Use>{});
            for (const EdgeUse& use : uses)
                found.back().second.emplace_back(!use.is_forward(), use.triangle());
        });
        const auto expected = uses_by_map(mesh);
        EXPECT_TRUE(std::ranges::equal(found, expected, [](const auto& a, const auto& b) {
            return a.first == b.first && a.second == b.second;
        }));
    }
}

TEST(EdgeUses, KeepNumbersUpToTheLargest)
{
    constexpr std::int32_t largest = 2147483646;
    const EdgeUse use{largest, 0, largest};
    EXPECT_EQ(use.high(), largest);
    EXPECT_EQ(use.triangle(), largest);
    EXPECT_FALSE(use.is_forward());
    EXPECT_TRUE(EdgeUse(0, largest, 0).is_forward());
}

TEST(DuplicateTriangles, AreThoseWithTheCornersOfAnEarlierOne)
{
    test::Random random{2};
    for (const int points : {4, 6, 15}) {
        const TriangleMesh mesh = random_triangles(random, points, 300);
        std::set<std::set<std::int32_t>> known;
        std::vector<std::int32_t> expected;
        for (std::int32_t k = 0; k < 300; ++k) {
            const Triangle& triangle = mesh.triangles()[k];
            const std::set<std::int32_t> corners(triangle.begin(), triangle.end());
            if (corners.size() == 3 && !known.insert(corners).second)
                expected.push_back(k);
        }
        EXPECT_FALSE(expected.empty());
        EXPECT_EQ(duplicate_triangles(EdgeUses{mesh}), expected);
    }
}

// Here the edges of a duplicate have no other triangles.
TEST(DuplicateTriangles, AreFoundAlone)
{
    std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {6, 8, 9}};
    const std::vector<Vec3> points(10, Vec3::Zero());
    EXPECT_TRUE(duplicate_triangles(EdgeUses{{points, triangles}}).empty());
    for (const Triangle& copy : {Triangle{5, 4, 3}, {2, 0, 1}, {8, 6, 7}})
        triangles.push_back(copy);
    EXPECT_EQ(duplicate_triangles(EdgeUses{{points, triangles}}),
              (std::vector<std::int32_t>{4, 5, 6}));
}

TEST(DuplicateTriangles, AreFoundAtPointsOfManyTriangles)
{
    for (const std::int32_t rim : {3, 15, 16, 17, 18, 100}) {
        std::vector<Triangle> fan;
        for (std::int32_t k = 1; k <= rim; ++k)
            fan.push_back({0, k, k % rim + 1});
        const std::vector<Vec3> points(rim + 1, Vec3::Zero());
        EXPECT_TRUE(duplicate_triangles(EdgeUses{{points, fan}}).empty());
        fan.push_back({fan[rim / 2][1], 0, fan[rim / 2][2]});
        EXPECT_EQ(duplicate_triangles(EdgeUses{{points, fan}}),
                  (std::vector<std::int32_t>{rim}));
    }
}

}  // namespace
}  // namespace endmill
