// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/several_setups.h"

#include <set>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/feasible_turns.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
#include "random_maps.h"
#include "teapot.h"
#include "turns_by_angles.h"

namespace endmill {
namespace {

const RotaryReach three_axes{.configuration = configuration_from_word("W/xyBz/T")};

RotaryReach reach_of(RotaryFamily family, const RotaryLimits& limits = {})
{
    return {.configuration = configuration_of_family(family), .limits = limits};
}

VisibilityMap teapot_map(const SphereGrid& grid, double incidence_deg)
{
    VisibilityOptions options;
    options.incidence = Angle::degrees(incidence_deg);
    return part_visibility(test::teapot(), grid.centres, options).map;
}

// Every facet appears once: in one of the setups, or as uncovered.
void expect_partition(const SetupCover& cover, std::size_t facets)
{
    std::set<std::size_t> seen;
    for (const PartialSetup& setup : cover.setups)
        for (const std::size_t facet : setup.facets)
            EXPECT_TRUE(seen.insert(facet).second) << facet;
    EXPECT_EQ(seen.size() + cover.uncovered.size(), facets);
}

// Source: docs/methods/five-axis-setup.md, section 9 (9.18).
TEST(SeveralSetups, ReachTheTeapotFromFourFiveAndSevenDirections)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const std::vector<std::pair<double, std::size_t>> counts{{90, 4}, {80, 5}, {60, 7}};
    for (const auto& [incidence_deg, count] : counts) {
        const VisibilityMap map = teapot_map(grid, incidence_deg);
        const SetupCover cover = greedy_setups(map, grid.centres, three_axes, 20);
        EXPECT_EQ(cover.setups.size(), count) << incidence_deg;
        EXPECT_TRUE(cover.uncovered.empty());
        expect_partition(cover, 288);
    }
}

TEST(SeveralSetups, AreOneWithFiveAxesWithoutLimitsAndMoreWithThem)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = teapot_map(grid, 90);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        RotaryReach reach = reach_of(family);
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

// The teapot has no bottom. A four-axis machine reaches all of it with 156 degrees about
// the axis from spout to handle.
TEST(SeveralSetups, WithFourAxesReachWhatTheArcReaches)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const VisibilityMap map = teapot_map(grid, 90);
    RotaryReach reach{.configuration = configuration_from_word("W/aBxyz/T")};
    reach.limits.phi = {-1.37, 1.37};  // 78.5 degrees to either side
    const SetupCover one = greedy_setups(map, grid.centres, reach, 1);
    EXPECT_TRUE(one.uncovered.empty());
    reach.limits.phi = {-0.1, 0.1};
    EXPECT_FALSE(greedy_setups(map, grid.centres, reach, 1).uncovered.empty());
}

TEST(SeveralSetups, AreTheSameOnAnyNumberOfThreads)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = teapot_map(grid, 80);
    const RotaryReach reach = reach_of(RotaryFamily::CA, {{-0.5, 0.5}, {-0.5, 0.5}});
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

std::set<std::size_t> with_a_cone(const VisibilityMap& map)
{
    std::set<std::size_t> facets;
    for (std::size_t facet = 0; facet < map.facets(); ++facet)
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            if (map.is_accessible(facet, cell))
                facets.insert(facet);
    return facets;
}

// The facets of `rest` that the machine reaches.
std::vector<std::size_t> reached_by(const RotaryFrame& frame, const VisibilityMap& map,
                                    std::span<const Vec3> centres,
                                    const RotaryReach& reach,
                                    const std::set<std::size_t>& rest)
{
    std::set<std::size_t> reached;
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        const bool is_taken = centres[cell] == frame.tool_axis ||
                              (!reach.configuration.rotary.empty() &&
                               test::takes(reach, frame, centres[cell]));
        for (const std::size_t facet : rest)
            if (is_taken && map.is_accessible(facet, cell))
                reached.insert(facet);
    }
    return {reached.begin(), reached.end()};
}

// The greedy rule without shortcuts: every candidate is counted anew for every setup.
SetupCover plain_greedy(const VisibilityMap& map, std::span<const Vec3> centres,
                        const RotaryReach& reach, std::size_t most)
{
    std::set<std::size_t> rest = with_a_cone(map);
    SetupCover cover;
    while (!rest.empty() && cover.setups.size() < most) {
        PartialSetup best;
        for (std::size_t pole = 0; pole < map.cells(); ++pole)
            for (std::size_t turn = 0; turn < turns_about_tool_axis; ++turn) {
                const RotaryFrame frame = frame_at(reach, centres[pole], turn);
                const auto reached = reached_by(frame, map, centres, reach, rest);
                if (reached.size() > best.facets.size())
                    best = {{frame.tool_axis, frame.r1_axis, frame.r2_axis}, reached};
            }
        for (const std::size_t facet : best.facets)
            rest.erase(facet);
        cover.setups.push_back(best);
    }
    cover.uncovered.assign(rest.begin(), rest.end());
    return cover;
}

void expect_equal(const SetupCover& found, const SetupCover& expected)
{
    EXPECT_EQ(found.uncovered, expected.uncovered);
    ASSERT_EQ(found.setups.size(), expected.setups.size());
    for (std::size_t i = 0; i < found.setups.size(); ++i) {
        EXPECT_EQ(found.setups[i].facets, expected.setups[i].facets);
        EXPECT_EQ(found.setups[i].pose.tool_axis, expected.setups[i].pose.tool_axis);
        EXPECT_EQ(found.setups[i].pose.r2_axis, expected.setups[i].pose.r2_axis);
    }
}

TEST(SeveralSetups, AreThoseOfTheRuleWithoutShortcuts)
{
    test::Random random{21};
    const SphereGrid grid = sphere_grid("hex:1");
    for (const RotaryReach& reach : test::reaches()) {
        // No cell is opposite to another one, where the turn of C is a result of
        // rounding.
        const std::vector<Vec3> centres(grid.centres.begin(), grid.centres.begin() + 6);
        const auto facets = static_cast<std::size_t>(random.uniform(1, 80));
        const VisibilityMap map = test::random_caps(facets, centres, random);
        const auto most = static_cast<std::size_t>(random.uniform(1, 6));
        expect_equal(greedy_setups(map, centres, reach, most),
                     plain_greedy(map, centres, reach, most));
    }
    const SphereGrid finer = sphere_grid("hex:2");
    const VisibilityMap map = test::random_caps(150, finer.centres, random);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const RotaryReach reach = reach_of(family, {{-0.3, 0.5}, {-0.4, 0.2}});
        expect_equal(greedy_setups(map, finer.centres, reach, 9),
                     plain_greedy(map, finer.centres, reach, 9));
    }
}

TEST(SeveralSetups, ReportProgress)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = teapot_map(grid, 80);
    std::size_t setup = 0;
    std::size_t tried = 0;
    const auto note = [&](const SetupCoverProgress& now) {
        EXPECT_TRUE(now.setup == setup ? now.tried > tried : now.setup == setup + 1);
        EXPECT_LE(now.tried, now.axes);
        setup = now.setup;
        tried = now.tried;
    };
    const SetupCover cover = greedy_setups(map, grid.centres, three_axes, 20, note);
    EXPECT_EQ(setup, cover.setups.size());
    const auto stop = [](const SetupCoverProgress&) { throw LimitError{"enough"}; };
    EXPECT_THROW(greedy_setups(map, grid.centres, three_axes, 20, stop), LimitError);
}

TEST(SeveralSetups, LeaveOutEmptyCones)
{
    const SphereGrid grid = sphere_grid("hex:1");
    VisibilityMap map{3, grid.centres.size()};
    map.column(2)[0] = 0b101;
    const SetupCover cover = greedy_setups(map, grid.centres, three_axes, 5);
    ASSERT_EQ(cover.setups.size(), 1U);
    EXPECT_EQ(cover.setups[0].facets, (std::vector<std::size_t>{0, 2}));
    EXPECT_TRUE(cover.uncovered.empty());
    const RotaryReach invalid{.configuration = configuration_from_word("W/cxyBz/T")};
    EXPECT_THROW(greedy_setups(map, {}, {}, 1), DomainError);
    EXPECT_THROW(greedy_setups(map, grid.centres, invalid, 1), DomainError);
    EXPECT_THROW(greedy_setups(map, grid.centres, {}, 0), DomainError);
}

}  // namespace
}  // namespace endmill
