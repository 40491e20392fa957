// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(VisibilityMap, BeginsWithNothingAccessible)
{
    const VisibilityMap map{130, 3};
    EXPECT_EQ(map.facets(), 130U);
    EXPECT_EQ(map.cells(), 3U);
    EXPECT_EQ(map.words(), 3U);
    for (std::size_t cell = 0; cell < 3; ++cell)
        for (std::size_t facet = 0; facet < 130; ++facet)
            EXPECT_FALSE(map.is_accessible(facet, cell));
}

TEST(VisibilityMap, KeepsABitForEachFacetOfAColumn)
{
    VisibilityMap map{130, 3};
    map.column(1)[2] = 0b10;
    map.column(2)[0] = std::uint64_t{1} << 63;
    for (std::size_t cell = 0; cell < 3; ++cell)
        for (std::size_t facet = 0; facet < 130; ++facet)
            EXPECT_EQ(map.is_accessible(facet, cell),
                      (cell == 1 && facet == 129) || (cell == 2 && facet == 63));
}

TEST(VisibilityMap, MayBeEmpty)
{
    EXPECT_EQ(VisibilityMap{}.cells(), 0U);
    EXPECT_EQ((VisibilityMap{0, 5}.column(4).size()), 0U);
}

TEST(VisibilityMap, ReportsMissingMemory)
{
    constexpr std::size_t many = std::size_t{1} << 31;
    EXPECT_THROW((VisibilityMap{many, many}), LimitError);
}

}  // namespace
}  // namespace endmill
