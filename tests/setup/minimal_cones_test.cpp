// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/minimal_cones.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/setup/detail/least_cones.h"
#include "random_maps.h"

namespace endmill {
namespace {

class CapsOnASphere : public testing::Test {
protected:
    test::Random random_{41};
    SphereGrid grid_ = sphere_grid("hex:4");
    VisibilityMap map_ = test::random_caps(1500, grid_.centres, random_);
    MinimalCones cones_{grid_, map_};
};

TEST_F(CapsOnASphere, HaveTheMinimalConesAndTheirCells)
{
    const ConeSet all{map_};
    EXPECT_EQ(cones_.size(), all.facets().size());
    EXPECT_TRUE(std::ranges::equal(cones_.cells(), all.cells()));
}

// The same is found by asking the map for each cone and each cell.
TEST_F(CapsOnASphere, NameTheConesThatCellsMissAndThatAreFar)
{
    const DistinctCones distinct{map_};
    const std::vector<std::size_t> least = least_cones(distinct);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 towards = test::random_direction(random_);
        std::vector<std::uint32_t> reached;
        for (std::size_t at = 0; at < cones_.cells().size(); ++at)
            if (grid_.centres[cones_.cells()[at]].dot(towards) > 0.5)
                reached.push_back(static_cast<std::uint32_t>(at));
        std::vector<std::size_t> expected;
        for (std::size_t number = 0; number < least.size(); ++number) {
            const std::size_t facet = distinct.first_facet(least[number]);
            if (std::ranges::none_of(reached, [&](std::uint32_t at) {
                    return map_.is_accessible(facet, cones_.cells()[at]);
                }))
                expected.push_back(number);
        }
        const std::vector<std::size_t> missed = cones_.missed(reached);
        EXPECT_EQ(missed.empty(), expected.empty());
        EXPECT_TRUE(std::ranges::includes(expected, missed));
    }
}

// More cones than `missed` combines at once. The same is found cone by cone, with the
// definition of distant cells.
TEST(MinimalCones, NameExactlyTheMissedConesOrTheDistantOnes)
{
    test::Random random{43};
    const SphereGrid grid = sphere_grid("hex:10");
    VisibilityMap map{1100, grid.centres.size()};
    for (std::size_t facet = 0; facet < map.facets(); ++facet)
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            if (random.uniform(0, 1) < 0.05)
                test::make_accessible(map, facet, cell);
    const MinimalCones cones{grid, map};
    ASSERT_GT(cones.size(), 1024U);
    const DistinctCones distinct{map};
    const std::vector<std::size_t> least = least_cones(distinct);
    const double step =
        1.5 * std::sqrt(4 * std::numbers::pi / double(grid.centres.size()));
    for (int trial = 0; trial < 6; ++trial) {
        const Vec3 towards = test::random_direction(random);
        std::vector<std::uint32_t> reached;
        std::vector<char> is_reached(cones.cells().size(), 0);
        std::vector<char> is_near(cones.cells().size(), 0);
        for (std::size_t at = 0; at < cones.cells().size(); ++at)
            if (grid.centres[cones.cells()[at]].dot(towards) > 0.98 - 0.09 * trial) {
                reached.push_back(static_cast<std::uint32_t>(at));
                is_reached[at] = 1;
            }
        for (const std::uint32_t from : reached)
            for (std::size_t at = 0; at < is_near.size(); ++at)
                if ((grid.centres[cones.cells()[at]] - grid.centres[cones.cells()[from]])
                        .norm() < step)
                    is_near[at] = 1;
        auto without = [&](const std::vector<char>& cells) {
            std::vector<std::size_t> numbers;
            for (std::size_t number = 0; number < least.size(); ++number) {
                const std::size_t facet = distinct.first_facet(least[number]);
                bool is_met = false;
                for (std::size_t at = 0; at < cells.size() && !is_met; ++at)
                    is_met =
                        cells[at] != 0 && map.is_accessible(facet, cones.cells()[at]);
                if (!is_met)
                    numbers.push_back(number);
            }
            return numbers;
        };
        const std::vector<std::size_t> distant = without(is_near);
        EXPECT_EQ(cones.missed(reached), distant.empty() ? without(is_reached) : distant);
    }
}

// Columns are filled in blocks of 64 x 64 bits. Each bit is asked from the map.
TEST_F(CapsOnASphere, FillColumnsWithTheBitsOfTheMap)
{
    for (const std::size_t count : {std::size_t{1}, std::size_t{63}, std::size_t{64},
                                    std::size_t{65}, cones_.size()}) {
        ASSERT_GE(cones_.size(), count);
        std::vector<std::size_t> numbers(count);
        for (std::size_t k = 0; k < count; ++k)
            numbers[k] = cones_.size() - count + k;
        const ConeSet set = cones_.selected(numbers);
        ASSERT_EQ(set.facets().size(), count);
        for (std::size_t at = 0; at < set.cells().size(); ++at)
            for (std::size_t bit = 0; bit < 64 * set.words(); ++bit) {
                const bool is_cone = bit < count;
                const std::uint64_t mask = std::uint64_t{1} << bit % 64;
                EXPECT_EQ((set.everything()[bit / 64] & mask) != 0, is_cone);
                EXPECT_EQ(
                    (set.missing(at)[bit / 64] & mask) != 0,
                    is_cone && !map_.is_accessible(set.facets()[bit], set.cells()[at]));
            }
    }
}

// Cells reached one after the other, each from a cone that was missed, meet all in the
// end.
TEST_F(CapsOnASphere, AreMetByACellOfEachMissedCone)
{
    std::vector<std::uint32_t> reached;
    std::size_t steps = 0;
    for (auto missed = cones_.missed(reached); !missed.empty();
         missed = cones_.missed(reached)) {
        const std::vector<std::size_t> one{missed.front()};
        const ConeSet set = cones_.selected(one);
        reached.push_back(static_cast<std::uint32_t>(set.smallest_cone().front()));
        ASSERT_LE(++steps, cones_.size());
    }
    std::vector<std::size_t> numbers(cones_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = k;
    const ConeSet all = cones_.selected(numbers);
    std::vector<std::uint64_t> open(all.everything(), all.everything() + all.words());
    const MissingWords<0> words{all.words()};
    for (const std::uint32_t at : reached)
        words.meet(open.data(), all.missing(at));
    EXPECT_TRUE(words.complete(open.data(), open.data()));
}

// Cones added one by one, beyond the end of a word, give the columns of all at once.
TEST_F(CapsOnASphere, GrowASetToTheSetOfAll)
{
    std::vector<std::size_t> numbers(cones_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = k;
    ASSERT_GT(numbers.size(), 64U);
    const ConeSet all = cones_.selected(numbers);
    ConeSet grown = cones_.selected(std::span{numbers}.first(3));
    for (const std::size_t number : std::span{numbers}.subspan(3))
        cones_.add(grown, number);
    ASSERT_EQ(grown.words(), all.words());
    EXPECT_TRUE(std::ranges::equal(grown.facets(), all.facets()));
    auto count = [&](const ConeSet& set, std::size_t at) {
        return std::transform_reduce(
            set.missing(at), set.missing(at) + set.words(), 0, std::plus{},
            [](std::uint64_t word) { return std::popcount(word); });
    };
    for (std::size_t at = 0; at < cones_.cells().size(); ++at)
        EXPECT_EQ(count(all, at), count(grown, at));
}

}  // namespace
}  // namespace endmill
