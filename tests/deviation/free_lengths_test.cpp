// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/free_lengths.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "revolved_surfaces.h"
#include "test_meshes.h"

namespace endmill {
namespace {

// Rays into the floor of a box 4 mm high, beside its wall x = 0: the wall or the top
// limits them.
TEST(FreeLengths, InABoxAreDistancesFromItsFaces)
{
    const Part box = test::box_mesh({0, 0, 0}, {40, 40, 4});
    const PartCharts charts = part_charts(box);
    const PartDistance distance{charts, 0.1};
    std::vector<PartWay> ways;
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 40; ++i)
            ways.push_back({{0.1 * i + 0.05, 20 + 0.1 * j, 4}, -Vec3::UnitZ(), 30});
    std::optional<std::size_t> hint;
    const std::vector<FreeLength> found = free_lengths(ways, distance, hint);
    ASSERT_EQ(found.size(), ways.size());
    int measured = 0;
    double sum = 0;
    double true_sum = 0;
    for (std::size_t k = 0; k < ways.size(); ++k) {
        const double truth = std::min(ways[k].foot.x(), 2.0);
        measured += found[k].is_measured ? 1 : 0;
        EXPECT_GE(found[k].length, truth - 1e-9);
        // A length exceeds the true one by more only where the limiting face changes
        // between two measured rays.
        EXPECT_LE(found[k].length, truth * (found[k].is_measured ? 1 + 1e-8 : 1.1));
        sum += found[k].length;
        true_sum += truth;
    }
    EXPECT_NEAR(sum, true_sum, 0.01 * true_sum);
    EXPECT_LT(measured, 200);
}

// Rays from the inside of a cylinder are limited by its axis.
TEST(FreeLengths, InACylinderAreItsRadius)
{
    const Part part =
        std::vector<Surface>{nurbs_surface(test::cylinder(20, 9, 0.3, 2.3))};
    const PartCharts charts = part_charts(part);
    const PartDistance distance{charts, 0.001};
    std::vector<PartWay> ways;
    for (int i = 0; i < 50; ++i) {
        const double angle = 1.2 + 0.005 * i;
        const Vec3 out{0, std::cos(angle), std::sin(angle)};
        ways.push_back({Vec3{4.5, 0, 0} + 20 * out, -out, 35});
    }
    std::optional<std::size_t> hint;
    for (const FreeLength& found : free_lengths(ways, distance, hint)) {
        EXPECT_GE(found.length, 19);
        EXPECT_LE(found.length, 20.3);
    }
}

TEST(FreeLengths, OfUnobstructedRaysAreTheirLengths)
{
    const Part box = test::box_mesh({0, 0, 0}, {4, 4, 4});
    const PartCharts charts = part_charts(box);
    const PartDistance distance{charts, 0.1};
    std::optional<std::size_t> hint;
    const std::vector<PartWay> ways{{{1, 1, 4}, Vec3::UnitZ(), 3},
                                    {{3, 1, 4}, Vec3::UnitZ(), 0.01}};
    const std::vector<FreeLength> found = free_lengths(ways, distance, hint);
    EXPECT_EQ(found[0].length, 3);
    EXPECT_EQ(found[1].length, 0.01);
    EXPECT_TRUE(free_lengths({}, distance, hint).empty());
}

}  // namespace
}  // namespace endmill
