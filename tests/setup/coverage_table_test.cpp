// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/coverage_table.h"

#include <random>

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

TEST(CoverageTable, ExcludesNoWindowThatTheSweepFinds)
{
    const SphereGrid grid = sphere_grid("hex:5");
    std::mt19937 random{4};
    std::uniform_real_distribution<double> uniform{0, 1};
    std::bernoulli_distribution is_open{0.1};
    std::size_t dead = 0;
    for (int trial = 0; trial < 40; ++trial) {
        VisibilityMap map{30, grid.centres.size()};
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            for (std::size_t facet = 0; facet < map.facets(); ++facet)
                if (is_open(random))
                    map.column(cell)[0] |= std::uint64_t{1} << facet;
        const ConeSet cones{map};
        std::vector<Vec3> centres;
        for (const std::size_t cell : cones.cells())
            centres.push_back(grid.centres[cell]);
        const Vec3 axis =
            Vec3{uniform(random), uniform(random), uniform(random)}.normalized();
        const auto family = trial % 2 == 0 ? RotaryFamily::CA : RotaryFamily::AB;
        const double radius = trial % 3 == 0 ? 0 : 0.1 * uniform(random);
        const AxisView view = axis_view({family, axis, radius, {1.5, 1.5}}, centres);
        CoverageTable table{cones};
        WindowSweep sweep{cones};
        table.fill(view, {1.5, 1.5});
        const std::vector<SweptRange> all{{0, view.swept.size()}};
        for (int k = 0; k < 20; ++k) {
            const LevelLimits limits{{1.5 * uniform(random), 1.5 * uniform(random)}};
            const double cap = 2 * uniform(random);
            const auto whole = sweep.least(view, all, limits, cap);
            const auto placed = sweep.least(view, table.places(limits, cap), limits, cap);
            ASSERT_EQ(whole.has_value(), placed.has_value());
            if (whole) {
                EXPECT_EQ(whole->width, placed->width);
            }
            if (whole) {
                EXPECT_TRUE(table.may_fit(limits, cap));
            }
            dead += table.may_fit(limits, cap) ? 0 : 1;
        }
    }
    EXPECT_GT(dead, 100U);  // the table must exclude many
}

}  // namespace
}  // namespace endmill
