// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/minimal_cones.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
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

// Cells reached one after the other, each from a cone that was missed, meet all in the
// end.
TEST_F(CapsOnASphere, AreMetByACellOfEachMissedCone)
{
    std::vector<std::uint32_t> reached;
    std::size_t steps = 0;
    for (auto missed = cones_.missed(reached); !missed.empty();
         missed = cones_.missed(reached)) {
        const std::vector<std::size_t> one{missed.front()};
        const ConeSet set = cones_.some(one);
        reached.push_back(static_cast<std::uint32_t>(set.smallest_cone().front()));
        ASSERT_LE(++steps, cones_.size());
    }
    std::vector<std::size_t> numbers(cones_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = k;
    const ConeSet all = cones_.some(numbers);
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
    const ConeSet all = cones_.some(numbers);
    ConeSet grown = cones_.some(std::span{numbers}.first(3));
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
