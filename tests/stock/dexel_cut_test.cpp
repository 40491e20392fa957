// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_cut.h"

#include <bitset>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// A ray of 64 units as its single units.
using Units = std::bitset<64>;

Units within(const DexelInterval& interval)
{
    Units units;
    for (std::int32_t k = interval.from; k < interval.to; ++k)
        units.set(static_cast<std::size_t>(k));
    return units;
}

Units units_of(const std::vector<DexelInterval>& set)
{
    Units units;
    for (const DexelInterval& one : set)
        units |= within(one);
    return units;
}

DexelInterval random_interval(test::Random& random)
{
    const auto from = static_cast<std::int32_t>(random.uniform(0, 64));
    return {from, std::min(64, from + static_cast<std::int32_t>(random.uniform(0, 12)))};
}

TEST(DexelCut, IntervalsAreRemovedUnitByUnit)
{
    test::Random random{3};
    for (int number = 0; number < 50; ++number) {
        std::vector<DexelInterval> set{{0, 64}};
        Units units = within(set.front());
        for (int k = 0; k < 20; ++k) {
            const DexelInterval cut = random_interval(random);
            const auto expected =
                static_cast<std::int64_t>((units & within(cut)).count());
            EXPECT_EQ(length_within(set, cut), expected);
            EXPECT_EQ(remove_interval(set, cut), expected);
            units &= ~within(cut);
            EXPECT_EQ(units_of(set), units);
        }
    }
}

TEST(DexelCut, UpperSetLosesWhatIsCertainLowerSetWhatIsPossible)
{
    Dexel dexel{{{0, 60}}, {{2, 58}}};
    const DexelCut cut = cut_dexel(dexel, {{10, 20}, {12, 19}});
    EXPECT_EQ(dexel.upper, (std::vector<DexelInterval>{{0, 12}, {19, 60}}));
    EXPECT_EQ(dexel.lower, (std::vector<DexelInterval>{{2, 10}, {20, 58}}));
    EXPECT_EQ(cut.removed, 7 + 10);
    EXPECT_EQ(cut.deepest, 7);
    EXPECT_EQ(cut.most_deep, 10);
}

}  // namespace
}  // namespace endmill
