// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_search.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random_maps.h"

namespace endmill {
namespace {

// Closed form: paper/notes/whole-cones.md, section 10. The search begins with one of the
// two cones, which every direction meets, and with a window that may have no width.
TEST(AxisSearch, ReachesTwoDirectionsAlongTheirArcAlsoInAWindowWithoutWidth)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const std::size_t from = 3;
    for (const std::size_t to : {40U, 111U, 170U}) {
        VisibilityMap map{2, grid.centres.size()};
        test::make_accessible(map, 0, from);
        test::make_accessible(map, 1, to);
        const MinimalCones cones{grid, map};
        const double apart = std::acos(grid.centres[from].dot(grid.centres[to]));
        WholeConeSearchOptions options;
        const double least = options.floor_rad * (apart + options.floor_rad);
        for (const double width : {3.1, 0.0}) {
            options.limits.theta = {-width, width};
            const WholeConeSearchResult found = axis_search(grid, cones, {0}, options);
            ASSERT_EQ(found.machinable, Answer::Yes);
            EXPECT_GE(found.objective, least * (1 - 1e-9));
            EXPECT_LE(found.objective, least * (1 + options.gap));
            EXPECT_LE(found.lower_bound, least * (1 + 1e-9));
            EXPECT_LE(found.objective, (1 + options.gap) * found.lower_bound * 1.000001);
            EXPECT_LE(found.ranges.width, 2 * width + 2e-9);
        }
    }
}

TEST(AxisSearch, HasBoundsBelowTheRangesOfASearchForAllConesAtOnce)
{
    test::Random random{36};
    const SphereGrid grid = sphere_grid("hex:4");
    const VisibilityMap map = test::random_caps(300, grid.centres, random);
    const MinimalCones cones{grid, map};
    std::vector<std::size_t> every(cones.size());
    for (std::size_t k = 0; k < every.size(); ++k)
        every[k] = k;
    using enum SetupObjective;
    for (const SetupObjective objective : {FlooredArea, Tilt})
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            WholeConeSearchOptions options;
            options.family = family;
            options.objective = objective;
            const WholeConeSearchResult all = axis_search(grid, cones, every, options);
            const WholeConeSearchResult few = axis_search(grid, cones, {0, 5}, options);
            for (const WholeConeSearchResult* found : {&all, &few}) {
                EXPECT_EQ(found->machinable, Answer::Yes);
                EXPECT_LE(found->objective,
                          (1 + options.gap) * found->lower_bound * (1 + 1e-12));
            }
            EXPECT_LE(few.lower_bound, all.objective);
            EXPECT_LE(all.lower_bound, few.objective);
        }
}

}  // namespace
}  // namespace endmill
