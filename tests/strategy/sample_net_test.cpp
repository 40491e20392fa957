// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/sample_net.h"

#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

std::vector<std::int32_t> without_twins(const TriangleMesh& mesh)
{
    std::vector<std::int32_t> own(mesh.points().size());
    std::iota(own.begin(), own.end(), 0);
    return own;
}

// A triangulated polygon of n points has as many border edges, and by Euler's formula the
// neighbours of all points are twice the edges.
TEST(SampleNet, HasTheBorderAndTheNeighboursOfAGrid)
{
    const TriangleMesh mesh = test::flat_mesh(4, 3);
    const auto own = without_twins(mesh);
    EXPECT_EQ(net_border(mesh.triangles(), own).size(), 14u);
    const SampleLists neighbours = net_neighbours(mesh.triangles(), own);
    const SampleLists triangles = net_triangles_at(mesh.triangles(), own.size());
    std::size_t ends = 0;
    std::size_t corners = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        ends += neighbours.of(i).size();
        corners += triangles.of(i).size();
    }
    const std::size_t edges = (3 * mesh.triangles().size() + 14) / 2;
    EXPECT_EQ(ends, 2 * edges);
    EXPECT_EQ(corners, 3 * mesh.triangles().size());
}

TEST(SampleNet, HasNoBorderBetweenTwins)
{
    const TriangleMesh mesh = test::both(test::flat_mesh(1, 1), test::flat_mesh(1, 1));
    auto representatives = without_twins(mesh);
    // the left side of the second square is at the right side of the first
    representatives[4] = 1;
    representatives[6] = 3;
    EXPECT_EQ(net_border(mesh.triangles(), representatives).size(), 6u);
    const SampleLists neighbours = net_neighbours(mesh.triangles(), representatives);
    EXPECT_EQ(std::ranges::count(neighbours.of(1), 4), 1);
}

TEST(SampleNet, DividesTrianglesAtTheMiddlesOfTheirEdges)
{
    const std::vector<Triangle> one{{0, 1, 2}};
    EdgeMiddles middles;
    EXPECT_EQ(divided_triangles(one, middles).size(), 1u);
    middles.add(1, 0, 3);
    EXPECT_EQ(divided_triangles(one, middles).size(), 2u);
    middles.add(1, 2, 4);
    EXPECT_EQ(divided_triangles(one, middles).size(), 3u);
    middles.add(2, 0, 5);
    EXPECT_EQ(divided_triangles(one, middles).size(), 4u);
    EXPECT_EQ(divided_triangles(one, middles, std::vector<char>{1}).size(), 4u);
    EXPECT_EQ(divided_triangles(one, middles, std::vector<char>{0}).size(), 1u);
    EXPECT_EQ(*middles.of(0, 1), 3);
    EXPECT_FALSE(middles.of(3, 1));
}

TEST(SampleNet, KeepsTheFirstMiddleOfEachOfManyEdges)
{
    constexpr std::int32_t ends = 300;
    EdgeMiddles middles;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> expected;
    for (std::int32_t a = 0; a < ends; ++a)
        for (std::int32_t step = 1; step < ends; step += 1 + a % 7) {
            const std::int32_t b = (a + step) % ends;
            const auto middle = static_cast<std::int32_t>(expected.size());
            middles.add(a, b, middle);
            expected.try_emplace({std::min(a, b), std::max(a, b)}, middle);
        }
    for (std::int32_t a = 0; a < ends; ++a)
        for (std::int32_t b = a + 1; b < ends; ++b) {
            const auto found = expected.find({a, b});
            const std::optional<std::int32_t> middle = middles.of(b, a);
            ASSERT_EQ(middle.has_value(), found != expected.end());
            if (middle) {
                ASSERT_EQ(*middle, found->second);
            }
        }
}

TEST(SampleNet, NumbersNeighboursNearEachOther)
{
    const TriangleMesh mesh = test::flat_mesh(31, 31);
    const auto numbers = numbers_by_place(mesh.points());
    std::vector<bool> is_used(numbers.size(), false);
    for (const std::int32_t number : numbers)
        is_used[number] = true;
    EXPECT_EQ(std::ranges::count(is_used, true), std::ssize(numbers));
    // the four corners of a cell of 8 by 8 points are within 64 numbers
    EXPECT_LT(std::abs(numbers[0] - numbers[7 * 32 + 7]), 64);
}

}  // namespace
}  // namespace endmill
