// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/economy_scaling.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// Tables with TCD = c delta^a D^b and NCL = TCD / (3 + delta); v costs 3 / 4 of u.
EconomyTables power_law(double a, double b)
{
    EconomyTables tables;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double delta = table_tolerances_mm[i];
                const double tcd = (k == 0 ? 4e7 : 3e7) * std::pow(delta, a) *
                                   std::pow(table_diameters_mm[j], b);
                const auto ncl =
                    static_cast<std::size_t>(std::llround(tcd / (3 + delta)));
                tables.runs[k][i][j] = {ncl, tcd};
            }
    return tables;
}

TEST(EconomyScaling, FindsTheExponentsOfAPowerLaw)
{
    const ScalingLaw law =
        scaling_law(power_law(-0.5, -0.47), TableQuantity::Tcd, Parameter::V);
    EXPECT_NEAR(law.tolerance_exponent, -0.5, 1e-12);
    EXPECT_NEAR(law.diameter_exponent, -0.47, 1e-12);
    EXPECT_LT(law.worst_residual, 1e-12);
}

TEST(EconomyScaling, HasAResidualWhereOneCellIsOff)
{
    EconomyTables tables = power_law(-0.5, -0.5);
    tables.runs[0][1][1].tcd_mm *= 1.09;
    const ScalingLaw law = scaling_law(tables, TableQuantity::Tcd, Parameter::U);
    EXPECT_GT(law.worst_residual, 0.03);
    EXPECT_LT(law.worst_residual, 0.09);
}

TEST(EconomyScaling, OfAPowerLawHasEqualReductions)
{
    const EconomyTables tables = power_law(-0.5, -0.5);
    const auto [least, greatest] = reductions_by_diameter(tables);
    EXPECT_NEAR(least, 1 - std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(greatest, 1 - std::sqrt(0.5), 1e-6);
    const auto between = reductions_between_directions(tables, TableQuantity::Tcd);
    EXPECT_NEAR(between.least, 0.25, 1e-12);
    EXPECT_NEAR(between.greatest, 0.25, 1e-12);
    EXPECT_LT(segment_spread(tables), 1e-6);
    EXPECT_TRUE(falls_with_diameter(tables));
    EXPECT_TRUE(v_beats_u(tables));
    EXPECT_FALSE(falls_with_diameter(power_law(-0.5, 0.1)));
}

TEST(EconomyScaling, MeasuresTheSegmentThatDependsOnTheBall)
{
    EconomyTables tables = power_law(-0.5, -0.5);
    for (int j = 0; j < 3; ++j)
        tables.runs[1][2][j] = {100, 100.0 * (1 + 0.1 * j)};
    EXPECT_NEAR(segment_spread(tables), 0.2 / 1.1, 1e-6);
}

// On a plane of area A with passes at the plane interval, TCD times the interval is A.
TEST(EconomyScaling, BoundsTheAreaByTravelTimesInterval)
{
    const double area = 24000;
    EconomyTables tables;
    for (auto& direction : tables.runs)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double R = table_diameters_mm[j] / 2;
                const double h = 0.8 * table_tolerances_mm[i];
                direction[i][j].tcd_mm = area / (2 * std::sqrt(2 * R * h - h * h));
            }
    const auto [least, greatest] = travel_times_plane_interval(tables, Parameter::U, 0.8);
    EXPECT_NEAR(least, area, 1e-8);
    EXPECT_NEAR(greatest, area, 1e-8);
}

TEST(EconomyScaling, MeasuresChangesAndDeviations)
{
    const EconomyTables before = power_law(-0.5, -0.5);
    EconomyTables after = before;
    for (auto& tolerance : after.runs[0])
        for (DirectionCost& run : tolerance)
            run.tcd_mm *= 1.02;
    EXPECT_NEAR(mean_change(before, after, TableQuantity::Tcd, Parameter::U), 0.02,
                1e-12);
    EXPECT_NEAR(mean_change(before, after, TableQuantity::Tcd, Parameter::V), 0, 1e-12);
    EXPECT_NEAR(worst_deviation(after, before), 0.02, 1e-12);
}

}  // namespace
}  // namespace endmill
