// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/setups.h"

#include <set>

#include <gtest/gtest.h>

#include "endmill/accessibility/sphere_grid.h"
#include "endmill/accessibility/visibility.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "random.h"
#include "teapot.h"

namespace endmill {
namespace {

VisibilityMap teapot_map(const SphereGrid& grid, double incidence_deg)
{
    VisibilityOptions options;
    options.incidence = Angle::degrees(incidence_deg);
    return part_visibility(test::teapot(), grid.centres, options).map;
}

// What the setups list is reached, once each, and nothing that could be is missing.
void expect_partition(const SetupCover& cover, std::size_t facets)
{
    std::set<std::size_t> seen;
    for (const PartialSetup& setup : cover.setups)
        for (const std::size_t facet : setup.facets)
            EXPECT_TRUE(seen.insert(facet).second) << facet;
    EXPECT_EQ(seen.size() + cover.uncovered.size(), facets);
}

// Source: spec of the five-axis setup, 9.18.
TEST(Setups, TeapotByDirectionsAloneNeedsFourFiveAndSeven)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const std::vector<std::pair<double, std::size_t>> counts{{90, 4}, {80, 5}, {60, 7}};
    for (const auto& [incidence_deg, count] : counts) {
        const VisibilityMap map = teapot_map(grid, incidence_deg);
        const SetupCover cover = greedy_setups(map, grid.centres, {.axes = 3}, 20);
        EXPECT_EQ(cover.setups.size(), count) << incidence_deg;
        EXPECT_TRUE(cover.uncovered.empty());
        expect_partition(cover, 288);
    }
}

TEST(Setups, OfFiveAxesOneDoesWithoutLimitsAndMoreWithThem)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = teapot_map(grid, 90);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        SetupReach reach{.family = family};
        EXPECT_EQ(greedy_setups(map, grid.centres, reach, 20).setups.size(), 1U);
        reach.limits = {{-0.6, 0.6}, {-0.4, 0.4}};
        const SetupCover several = greedy_setups(map, grid.centres, reach, 20);
        EXPECT_GT(several.setups.size(), 1U);
        EXPECT_LT(several.setups.size(), 20U);
        EXPECT_TRUE(several.uncovered.empty());
        expect_partition(several, 288);
        const SetupCover first = greedy_setups(map, grid.centres, reach, 1);
        ASSERT_EQ(first.setups.size(), 1U);
        EXPECT_EQ(first.setups[0].facets, several.setups[0].facets);
        EXPECT_FALSE(first.uncovered.empty());
        expect_partition(first, 288);
    }
}

// The bottomless teapot is machinable about the axis from spout to handle with 156 degrees.
TEST(Setups, AMachineOfFourAxesReachesAsMuchAsItsArc)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const VisibilityMap map = teapot_map(grid, 90);
    SetupReach reach{.axes = 4};
    reach.limits.phi = {-1.37, 1.37};  // 78.5 degrees either way
    const SetupCover one = greedy_setups(map, grid.centres, reach, 1);
    EXPECT_TRUE(one.uncovered.empty());
    reach.limits.phi = {-0.1, 0.1};
    EXPECT_FALSE(greedy_setups(map, grid.centres, reach, 1).uncovered.empty());
}

TEST(Setups, AreTheSameOnAnyNumberOfThreads)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = teapot_map(grid, 80);
    const SetupReach reach{.limits = {{-0.5, 0.5}, {-0.5, 0.5}}};
    const SetupCover all = greedy_setups(map, grid.centres, reach, 10);
    set_thread_count(1);
    const SetupCover one = greedy_setups(map, grid.centres, reach, 10);
    set_thread_count(4);
    ASSERT_EQ(all.setups.size(), one.setups.size());
    for (std::size_t i = 0; i < all.setups.size(); ++i) {
        EXPECT_EQ(all.setups[i].facets, one.setups[i].facets);
        EXPECT_EQ(all.setups[i].pose.r2_axis, one.setups[i].pose.r2_axis);
    }
}

TEST(Setups, LeaveOutWhatNothingReaches)
{
    const SphereGrid grid = sphere_grid("hex:1");
    VisibilityMap map{3, grid.centres.size()};
    map.column(2)[0] = 0b101;
    const SetupCover cover = greedy_setups(map, grid.centres, {.axes = 3}, 5);
    ASSERT_EQ(cover.setups.size(), 1U);
    EXPECT_EQ(cover.setups[0].facets, (std::vector<std::size_t>{0, 2}));
    EXPECT_TRUE(cover.uncovered.empty());
    EXPECT_THROW(greedy_setups(map, {}, {}, 1), DomainError);
    EXPECT_THROW(greedy_setups(map, grid.centres, {.axes = 2}, 1), DomainError);
    EXPECT_THROW(greedy_setups(map, grid.centres, {}, 0), DomainError);
}

}  // namespace
}  // namespace endmill
