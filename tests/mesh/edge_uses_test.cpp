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

}  // namespace
}  // namespace endmill
