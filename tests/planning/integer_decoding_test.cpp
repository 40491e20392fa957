// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/integer_decoding.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// A row with passes of chord length L: f points on forward passes and b on backward ones.
CostRow made_row(const std::array<int, 3>& passes, int f, int b, double chord,
                 double link)
{
    CostRow row{};
    for (int j = 0; j < 3; ++j) {
        row.ncl[j] = (f + b) * (passes[j] / 2) + (passes[j] % 2) * f;
        row.tcd_mm[j] = passes[j] * chord + link;
    }
    return row;
}

TEST(IntegerDecoding, FindsTheWholeNumbersOfARow)
{
    const CostRow row = made_row({61, 49, 42}, 12, 15, 231.5, 140);
    const std::vector<Decoding> found = decodings(row, 1e-9, {200, 480});
    const auto decoding = std::ranges::find(found, 27, &Decoding::points_a_pair);
    ASSERT_NE(decoding, found.end());
    EXPECT_EQ(decoding->points_forward, 12);
    EXPECT_EQ(decoding->passes, (std::array{61, 49, 42}));
    EXPECT_NEAR(decoding->chord_mm, 231.5, 1e-9);
    EXPECT_NEAR(decoding->link_mm, 140, 1e-8);
    EXPECT_LT(decoding->residual_mm, 1e-9);
}

TEST(IntegerDecoding, LeavesTheForwardPointsOpenWhenAllPassesArePaired)
{
    const CostRow row = made_row({60, 48, 42}, 12, 15, 231.5, 140);
    const std::vector<Decoding> found = decodings(row, 1e-9, {200, 480});
    const auto decoding = std::ranges::find(found, 27, &Decoding::points_a_pair);
    ASSERT_NE(decoding, found.end());
    EXPECT_FALSE(decoding->points_forward.has_value());
}

TEST(IntegerDecoding, RefusesRowsBeyondTheToleranceOrTheChord)
{
    CostRow row = made_row({61, 49, 42}, 12, 15, 231.5, 140);
    EXPECT_TRUE(decodings(row, 1e-9, {250, 480}).empty());
    row.tcd_mm[1] += 5;
    for (const Decoding& decoding : decodings(row, 1, {200, 480}))
        EXPECT_NE(decoding.points_a_pair, 27);
}

TEST(IntegerDecoding, CountsTriplesWithOneChord)
{
    const auto with = [](double chord) {
        return Decoding{2, std::nullopt, {}, chord, 0, 0};
    };
    const std::array<std::vector<Decoding>, 3> readings{
        std::vector{with(200), with(300)}, {with(201)}, {with(202), with(300)}};
    EXPECT_EQ(one_chord_triples(readings, 0.011), 1);
    EXPECT_EQ(one_chord_triples(readings, 0.001), 0);
    EXPECT_EQ(one_chord_triples(readings, 1), 4);
}

TEST(IntegerDecoding, TakesTheSidesOfThePartAsChordBounds)
{
    const DecodingRules rules{0.05, 0.01, 2.4};
    EXPECT_EQ(chord_bounds(Parameter::U, rules).low, 200);
    EXPECT_DOUBLE_EQ(chord_bounds(Parameter::V, rules).high, 2.4 * 120);
}

TEST(IntegerDecoding, NullTestCountsWithinItsTrialsAndRepeats)
{
    EconomyTables printed;
    for (auto& direction : printed.runs)
        for (auto& tolerance : direction)
            tolerance = {DirectionCost{1300, 8000}, {1000, 6500}, {800, 5500}};
    const DecodingRules rules{0.5, 0.01, 2.4};
    const NullTest test = null_test(printed, rules, 20, 1);
    EXPECT_EQ(test.rows, 60);
    EXPECT_EQ(test.triples, 20);
    EXPECT_LE(test.rows_read, test.rows);
    EXPECT_LE(3 * test.triples_read, test.rows_read);
    EXPECT_EQ(null_test(printed, rules, 20, 1).rows_read, test.rows_read);
    const DecodingRules wide{1e9, 10, 100};
    EXPECT_GE(null_test(printed, wide, 20, 1).rows_read, test.rows_read);
}

}  // namespace
}  // namespace endmill
