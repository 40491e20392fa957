// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/economy_tables.h"

#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

// Passes on a plane are straight: two points each. Their number follows from the interval
// 2 sqrt(2 R h - h^2), one more than the whole intervals, plus the pass on the border.
TEST(EconomyTables, OnAPlaneHaveTheirClosedForm)
{
    const EconomyTables tables = planned_tables(test::plane(200, 120));
    for (const Parameter direction : table_directions)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double along = direction == Parameter::U ? 200 : 120;
                const double across = 320 - along;
                const double R = table_diameters_mm[j] / 2;
                const double h = table_tolerances_mm[i];
                const double passes =
                    std::ceil(across / (2 * std::sqrt(2 * R * h - h * h))) + 1;
                EXPECT_EQ(tables.cell(TableQuantity::Ncl, direction, i, j), 2 * passes);
                EXPECT_NEAR(tables.cell(TableQuantity::Tcd, direction, i, j),
                            passes * along + across, 1e-8);
            }
}

TEST(EconomyTables, ReduceAsThePaperDefines)
{
    EconomyTables tables;
    tables.runs[0][1] = {DirectionCost{800, 4000}, {600, 3500}, {400, 3000}};
    tables.runs[1][1] = {DirectionCost{1000, 5000}, {500, 3500}, {250, 1500}};
    EXPECT_DOUBLE_EQ(tables.reduction_between_directions(TableQuantity::Ncl, 1, 0), 0.2);
    EXPECT_DOUBLE_EQ(tables.reduction_between_directions(TableQuantity::Tcd, 1, 1), 0);
    EXPECT_DOUBLE_EQ(tables.reduction_by_diameter(TableQuantity::Ncl, Parameter::U, 1),
                     0.5);
    EXPECT_DOUBLE_EQ(tables.reduction_by_diameter(TableQuantity::Tcd, Parameter::V, 1),
                     0.7);
}

TEST(EconomyTables, FollowThePolicies)
{
    const Surface trough = test::parabolic_cylinder(0.02, 10, 30);
    const ToolPath path = table_plan(trough, {}, Parameter::U, 0.5, 10).path;
    const PathEconomy economy = path_economy(path);
    const auto travel = [&](CountedMoves counted, TravelKind distance) {
        TablePolicies policies;
        policies.counted = counted;
        policies.distance = distance;
        return path_cost(path, policies).tcd_mm;
    };
    EXPECT_EQ(travel(CountedMoves::CutsAndLinks, TravelKind::Contact),
              economy.cut.contact_mm + economy.link.contact_mm);
    EXPECT_EQ(travel(CountedMoves::Cuts, TravelKind::Contact), economy.cut.contact_mm);
    EXPECT_EQ(travel(CountedMoves::CutsAndLinks, TravelKind::Tip),
              economy.cut.tip_mm + economy.link.tip_mm);
    EXPECT_EQ(travel(CountedMoves::Cuts, TravelKind::Tip), economy.cut.tip_mm);
}

}  // namespace
}  // namespace endmill
