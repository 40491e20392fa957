// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/many_cones_search.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "random_maps.h"

namespace endmill {
namespace {

// Both searches find a pose and a bound. Neither bound exceeds the objective of the other
// pose.
void expect_consistent(const WholeConeSearchResult& one,
                       const WholeConeSearchResult& other, double gap)
{
    EXPECT_LE(one.lower_bound, other.objective);
    EXPECT_LE(other.lower_bound, one.objective);
    EXPECT_LE(one.objective, (1 + gap) * one.lower_bound * (1 + 1e-12));
}

TEST(ManyConesSearch, AgreesWithTheSearchForAllCones)
{
    test::Random random{31};
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = test::random_caps(120, grid.centres, random);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
        for (const SetupObjective objective :
             {SetupObjective::FlooredArea, SetupObjective::TotalRange}) {
            WholeConeSearchOptions options;
            options.family = family;
            options.objective = objective;
            const WholeConeSearchResult grown = many_cones_search(grid, map, options, 8);
            ASSERT_TRUE(grown.pose);
            const WholeConeSearchResult whole = whole_cone_search(grid, map, options);
            expect_consistent(grown, whole, options.gap);
            // The search does not begin again when cones are added.
            EXPECT_LE(grown.nodes, 2 * whole.nodes);
            const WholeConeSearchResult once =
                many_cones_search(grid, map, options, 1000);
            EXPECT_EQ(once.objective, whole_cone_search(grid, map, options).objective);
        }
}

// The gap is so wide that every pose meets it.
TEST(ManyConesSearch, IsNeverWorseThanItsStarts)
{
    test::Random random{34};
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = test::random_caps(120, grid.centres, random);
    WholeConeSearchOptions options;
    const WholeConeSearchResult best = whole_cone_search(grid, map, options);
    options.gap = 1000;
    const std::vector<SetupPose> starts{best.pose->pose};
    options.starts = starts;
    EXPECT_LE(many_cones_search(grid, map, options, 8).objective,
              best.objective * (1 + 1e-12));
}

TEST(ManyConesSearch, ProvesFromSomeConesThatNoPoseFits)
{
    test::Random random{32};
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = test::random_caps(120, grid.centres, random);
    WholeConeSearchOptions options;
    options.limits = {{-0.3, 0.3}, {-0.3, 0.3}};
    EXPECT_EQ(many_cones_search(grid, map, options, 16).machinable, Answer::No);
}

TEST(ManyConesSearch, IsTheSameForAnyNumberOfThreadsAndReportsProgress)
{
    test::Random random{33};
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = test::random_caps(100, grid.centres, random);
    WholeConeSearchOptions options;
    options.family = RotaryFamily::AB;
    const WholeConeSearchResult silent = many_cones_search(grid, map, options, 12);
    std::size_t nodes = 0;
    double bound = 0;
    options.progress = [&](const WholeConeSearchProgress& now) {
        EXPECT_GT(now.nodes, nodes);
        EXPECT_GE(now.lower_bound, 0);
        nodes = now.nodes;
        bound = now.lower_bound;
    };
    for (const int threads : {1, 8}) {
        nodes = 0;
        set_thread_count(threads);
        const WholeConeSearchResult found = many_cones_search(grid, map, options, 12);
        EXPECT_EQ(found.objective, silent.objective);
        EXPECT_EQ(found.lower_bound, silent.lower_bound);
        EXPECT_EQ(found.nodes, silent.nodes);
        EXPECT_EQ(found.pose->pose.r1_axis, silent.pose->pose.r1_axis);
        EXPECT_EQ(nodes, silent.nodes);
        EXPECT_LE(bound, found.objective);
    }
    set_thread_count(4);
    EXPECT_THROW(many_cones_search(grid, map, options, 3), DomainError);
}

}  // namespace
}  // namespace endmill
