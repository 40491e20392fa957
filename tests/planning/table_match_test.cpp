// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/table_match.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// All NCL 1000, all TCD 20 000 mm.
EconomyTables round_tables()
{
    EconomyTables tables;
    for (auto& direction : tables.runs)
        for (auto& row : direction)
            row.fill({1000, 20'000});
    return tables;
}

TEST(TableMatch, CountsEqualPointsAndTravelWithinTheLastDigit)
{
    const EconomyTables target = round_tables();
    EconomyTables tables = target;
    tables.runs[0][0][0] = {1001, 20'000.1};
    tables.runs[1][2][1] = {1000, 20'000.11};
    tables.runs[1][2][2] = {999, 19'800};
    const TableMatch match = table_match(tables, target);
    EXPECT_EQ(match.ncl, 16);
    EXPECT_EQ(match.tcd, 16);
    // 4 % of 1000 points are 40 possible numbers; of 20 000 mm, 4000 intervals of 0.2 mm.
    EXPECT_NEAR(match.information, 16 * std::log2(40) + 16 * std::log2(4000), 1e-12);
    EXPECT_NEAR(match.choice, std::log2(36.0 * 35 * 34 * 33 / 24), 1e-9);
    EXPECT_NEAR(match.worst_percent, 1, 1e-12);
}

TEST(TableMatch, OfOneDirectionIgnoresTheOther)
{
    const EconomyTables target = round_tables();
    EconomyTables tables = target;
    for (auto& row : tables.runs[1])
        row.fill({1, 1});
    constexpr std::array along_u{Parameter::U};
    constexpr std::array points{TableQuantity::Ncl};
    const TableMatch match = table_match(tables, target, along_u, points);
    EXPECT_EQ(match.ncl, 9);
    EXPECT_EQ(match.tcd, 0);
    EXPECT_EQ(match.choice, 0);
    EXPECT_EQ(match.rms_percent, 0);
    EXPECT_EQ(match.deviation, 0);
}

TEST(TableMatch, IgnoresRunsThatTheTargetLeavesOut)
{
    EconomyTables target = round_tables();
    target.runs[1][0] = {};
    EconomyTables tables = round_tables();
    tables.runs[1][0].fill({1, 1});
    const TableMatch match = table_match(tables, target);
    EXPECT_EQ(match.ncl, 15);
    EXPECT_EQ(match.tcd, 15);
    EXPECT_EQ(match.choice, 0);
    EXPECT_EQ(match.worst_percent, 0);
    EXPECT_EQ(match.deviation, 0);
    EXPECT_EQ(deviation_bits(tables, target), 0);
    EXPECT_EQ(table_match(tables, EconomyTables{}).rms_percent, 0);
}

TEST(TableMatch, DeviationGrowsByABitWhenItDoubles)
{
    for (const TableQuantity quantity : table_quantities) {
        EXPECT_EQ(deviation_bits(quantity, 0), 0);
        EXPECT_NEAR(deviation_bits(quantity, 2e6) - deviation_bits(quantity, 1e6), 1,
                    1e-9);
        EXPECT_EQ(deviation_bits(quantity, 3), deviation_bits(quantity, -3));
    }
    const EconomyTables target = round_tables();
    EXPECT_EQ(deviation_bits(target, target), 0);
}

// A match that needs |x - 5| < 0.1 and |y + 1| < 0.4 in ranges of length 20: 0.2 and 0.8 of 20.
TEST(TableMatch, ChargesTheLogarithmOfRangeOverWidth)
{
    const std::vector<Interval> ranges{{-10, 10}, {-10, 10}, {-10, 10}};
    const auto matched = [](std::span<const double> x) {
        return (std::abs(x[0] - 5) < 0.1 ? 1 : 0) + (std::abs(x[1] + 1) < 0.4 ? 1 : 0);
    };
    const std::vector<double> values{5, -1, 3};
    // The third value does not matter: one bit. Bisection finds a width to about 6 %.
    EXPECT_NEAR(bits_of_values(values, ranges, matched),
                std::log2(20 / 0.2) + std::log2(20 / 0.8) + 1, 0.2);
}

TEST(TableMatch, ChargesAValueAtTheEndOfItsRange)
{
    const std::vector<Interval> ranges{{0, 1}};
    const auto matched = [](std::span<const double> x) { return x[0] < 0.25 ? 1 : 0; };
    EXPECT_NEAR(bits_of_values(std::vector{0.0}, ranges, matched), 2, 0.1);
}

}  // namespace
}  // namespace endmill
