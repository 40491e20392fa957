// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/structureless_tables.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/planning/detail/integer_decoding.h"

namespace endmill {
namespace {

// Tables that follow power laws exactly, up to rounding: NCL = 600 / (delta sqrt(R / 5)) along u,
// 450 / (delta sqrt(R / 5)) along v, and TCD = 27 sqrt(delta) NCL + 300.
EconomyTables smooth_tables()
{
    EconomyTables tables;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double delta = table_tolerances_mm[i];
                const double size = k == 0 ? 600 : 450;
                const double points =
                    std::round(size / (delta * std::sqrt(table_diameters_mm[j] / 10)));
                tables.runs[k][i][j] = {static_cast<std::size_t>(points),
                                        27 * std::sqrt(delta) * points + 300};
            }
    return tables;
}

TEST(StructurelessTables, KeepTheScaling)
{
    const EconomyTables printed = smooth_tables();
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
        const EconomyTables tables = structureless_tables(printed, seed);
        for (const TableQuantity quantity : table_quantities)
            for (const Parameter direction : table_directions)
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) {
                        const double cell = printed.cell(quantity, direction, i, j);
                        // The residuals of the smooth tables are their rounding, 0.1 %.
                        EXPECT_NEAR(tables.cell(quantity, direction, i, j), cell,
                                    0.01 * cell);
                    }
    }
}

TEST(StructurelessTables, HavePointsAndTravelOnALine)
{
    const EconomyTables tables = structureless_tables(smooth_tables(), 5);
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i) {
            const auto& [a, b, c] = tables.runs[k][i];
            const double share =
                (double(b.ncl) - double(c.ncl)) / (double(a.ncl) - double(c.ncl));
            const double between = c.tcd_mm + share * (a.tcd_mm - c.tcd_mm);
            EXPECT_NEAR(b.tcd_mm, between, 1.2);  // twice 0.5 mm and rounding
        }
}

// Rows whose numbers of passes are whole all have an interpretation. Of rows without structure
// about a third have one by chance, because the interpretation has as many unknowns as a row
// has numbers; of triples of rows with one chord length, few.
TEST(StructurelessTables, RarelyHaveAnInterpretationByWholeNumbers)
{
    const EconomyTables printed = smooth_tables();
    const DecodingRules rules{1.3, 0.015, 4};
    int read = 0;
    int triples = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const EconomyTables tables = structureless_tables(printed, seed);
        for (int k = 0; k < 2; ++k) {
            const auto readings = readings_of(tables, k, rules);
            for (const std::vector<Decoding>& row : readings)
                read += row.empty() ? 0 : 1;
            triples += one_chord_triples(readings, rules.chord_spread) > 0 ? 1 : 0;
        }
    }
    EXPECT_LT(read, 600);    // half of the 1200 rows
    EXPECT_LT(triples, 40);  // a tenth of the 400 triples
}

TEST(StructurelessTables, DependOnTheSeed)
{
    const EconomyTables printed = smooth_tables();
    const auto travel = [&](std::uint32_t seed) {
        return structureless_tables(printed, seed).runs[0][1][1].tcd_mm;
    };
    EXPECT_EQ(travel(1), travel(1));
    EXPECT_NE(travel(1), travel(2));
}

}  // namespace
}  // namespace endmill
