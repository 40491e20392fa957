// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/cone_set.h"

#include <random>

#include <gtest/gtest.h>

namespace endmill {
namespace {

void open_cells(VisibilityMap& map, std::size_t facet,
                std::initializer_list<std::size_t> cells)
{
    for (const std::size_t cell : cells)
        map.column(cell)[facet / 64] |= std::uint64_t{1} << facet % 64;
}

std::vector<std::size_t> listed(std::span<const std::size_t> numbers)
{
    return {numbers.begin(), numbers.end()};
}

TEST(ConeSet, LeavesOutEmptyEqualAndLargerCones)
{
    VisibilityMap map{5, 6};
    open_cells(map, 0, {1, 2, 3});
    open_cells(map, 1, {2, 3});  // part of cone 0
    open_cells(map, 3, {2, 3});  // equal to cone 1
    open_cells(map, 4, {5});     // cone 2 is empty
    const ConeSet cones{map};
    EXPECT_EQ(listed(cones.facets()), (std::vector<std::size_t>{1, 4}));
    EXPECT_EQ(listed(cones.cells()), (std::vector<std::size_t>{2, 3, 5}));
    EXPECT_EQ(listed(cones.smallest_cone()), (std::vector<std::size_t>{2}));  // cell 5
    EXPECT_EQ(listed(cones.other_cone()), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(cones.everything()[0], 3U);
    EXPECT_EQ(cones.missing(0)[0], 2U);
    EXPECT_EQ(cones.missing(2)[0], 1U);
}

TEST(ConeSet, IsEmptyWithoutCones)
{
    const ConeSet cones{VisibilityMap{4, 6}};
    EXPECT_TRUE(cones.facets().empty());
    EXPECT_TRUE(cones.cells().empty());
    EXPECT_TRUE(cones.smallest_cone().empty());
}

TEST(ConeSet, IsMetExactlyByTheSetsThatMeetAllCones)
{
    std::mt19937 random{1};
    std::bernoulli_distribution is_open{0.3};
    VisibilityMap map{150, 20};
    for (std::size_t cell = 0; cell < 20; ++cell)
        for (std::size_t facet = 0; facet < 150; ++facet)
            if (is_open(random))
                open_cells(map, facet, {cell});
    const ConeSet cones{map};
    EXPECT_TRUE(cones.words() == 1 || cones.words() == 2 || cones.words() % 4 == 0);
    EXPECT_GE(64 * cones.words(), cones.facets().size());
    const MissingWords<0> words{cones.words()};
    std::bernoulli_distribution is_taken{0.5};
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<std::uint64_t> missing(cones.everything(),
                                           cones.everything() + cones.words());
        std::vector<char> taken(20);
        for (std::size_t k = 0; k < cones.cells().size(); ++k) {
            taken[cones.cells()[k]] = is_taken(random) ? 1 : 0;
            if (taken[cones.cells()[k]] != 0)
                words.meet(missing.data(), cones.missing(k));
        }
        bool meets_all = true;
        for (std::size_t facet = 0; facet < 150; ++facet) {
            bool is_empty = true;
            bool is_met = false;
            for (std::size_t cell = 0; cell < 20; ++cell) {
                is_empty = is_empty && !map.is_accessible(facet, cell);
                is_met = is_met || (taken[cell] != 0 && map.is_accessible(facet, cell));
            }
            meets_all = meets_all && (is_empty || is_met);
        }
        EXPECT_EQ(words.complete(missing.data(), missing.data()), meets_all);
    }
}

TEST(ConeSet, PassesSmallNumbersOfWordsAsConstants)
{
    for (const std::size_t words : {1, 2, 4, 8, 12, 16})
        EXPECT_EQ(with_words(words, [](auto w) { return decltype(w)::value; }), words);
    EXPECT_EQ(with_words(20, [](auto w) { return decltype(w)::value; }), 0U);
}

}  // namespace
}  // namespace endmill
