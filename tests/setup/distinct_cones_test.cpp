// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/distinct_cones.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"
#include "random_maps.h"

namespace endmill {
namespace {

std::vector<bool> row_of(const VisibilityMap& map, std::size_t facet)
{
    std::vector<bool> row(map.cells());
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        row[cell] = map.is_accessible(facet, cell);
    return row;
}

TEST(DistinctCones, AreTheDifferentRowsInTheOrderOfTheirFirstFacets)
{
    test::Random random{5};
    for (const std::size_t facets : {1U, 63U, 64U, 65U, 300U}) {
        const SphereGrid grid = sphere_grid("hex:3");
        const VisibilityMap map = test::random_caps(facets, grid.centres, random);
        std::map<std::vector<bool>, std::size_t> numbers;
        std::vector<std::size_t> counts;
        std::vector<std::size_t> expected;
        for (std::size_t facet = 0; facet < facets; ++facet) {
            const std::vector<bool> row = row_of(map, facet);
            if (row == std::vector<bool>(map.cells(), false)) {
                expected.push_back(DistinctCones::none);
                continue;
            }
            const auto [at, is_new] = numbers.insert({row, counts.size()});
            if (is_new)
                counts.push_back(0);
            ++counts[at->second];
            expected.push_back(at->second);
        }
        const DistinctCones cones{map};
        ASSERT_EQ(cones.size(), counts.size());
        EXPECT_EQ(std::vector(cones.cone_of().begin(), cones.cone_of().end()), expected);
        const VisibilityMap merged = cones.map();
        EXPECT_EQ(merged.facets(), counts.size());
        for (std::size_t facet = 0; facet < facets; ++facet) {
            if (expected[facet] != DistinctCones::none) {
                EXPECT_EQ(row_of(merged, expected[facet]), row_of(map, facet));
            }
        }
        for (std::size_t cone = 0; cone < counts.size(); ++cone)
            EXPECT_EQ(cones.facets(cone), counts[cone]);
        for (std::size_t cell = 0; cell < map.cells() && merged.facets() % 64 != 0;
             ++cell)
            EXPECT_EQ(merged.column(cell).back() >> (merged.facets() % 64), 0U);
    }
}

// Caps about normals in a random order. The distance of one normal from the next is small on
// average only if similar cones lie side by side; at random it is a right angle.
TEST(DistinctCones, LieSideBySideIfTheyAreSimilar)
{
    test::Random random{8};
    const SphereGrid grid = sphere_grid("hex:6");
    std::vector<Vec3> normals;
    VisibilityMap map{2000, grid.centres.size()};
    for (std::size_t facet = 0; facet < map.facets(); ++facet) {
        normals.push_back(test::random_direction(random));
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            if (normals.back().dot(grid.centres[cell]) > 0)
                map.column(cell)[facet / 64] |= std::uint64_t{1} << facet % 64;
        }
    }
    const DistinctCones cones{map};
    const std::vector<std::size_t> order = cones.similar_together();
    double turned = 0;  // rad
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        turned += std::acos(normals[cones.first_facet(order[i])].dot(
            normals[cones.first_facet(order[i + 1])]));
    EXPECT_LT(turned / static_cast<double>(order.size()), 0.3);
    std::vector<std::size_t> sorted = order;
    std::ranges::sort(sorted);
    for (std::size_t cone = 0; cone < cones.size(); ++cone)
        EXPECT_EQ(sorted[cone], cone);
    EXPECT_EQ(sorted.size(), cones.size());
}

// Facets 0, 2 and 3 have the same cone, facet 1 another one, facet 4 none.
TEST(DistinctCones, HaveAMapWithOneFacetForEach)
{
    VisibilityMap map{5, 70};
    for (const std::size_t cell : {3, 69})
        map.column(cell)[0] = 0b01101;
    map.column(5)[0] = 0b00010;
    const VisibilityMap cones = map_of_distinct_cones(map);
    ASSERT_EQ(cones.facets(), 2U);
    ASSERT_EQ(cones.cells(), 70U);
    const std::size_t of_three = cones.is_accessible(0, 3) ? 0 : 1;
    for (std::size_t cell = 0; cell < 70; ++cell) {
        EXPECT_EQ(cones.is_accessible(of_three, cell), cell == 3 || cell == 69);
        EXPECT_EQ(cones.is_accessible(1 - of_three, cell), cell == 5);
    }
}

TEST(DistinctCones, MayBeEmpty)
{
    EXPECT_EQ(DistinctCones(VisibilityMap{}).size(), 0U);
    const DistinctCones cones{VisibilityMap{70, 5}};
    EXPECT_EQ(cones.size(), 0U);
    EXPECT_EQ(cones.cone_of()[69], DistinctCones::none);
    EXPECT_EQ(cones.map().facets(), 0U);
    EXPECT_TRUE(cones.similar_together().empty());
}

}  // namespace
}  // namespace endmill
