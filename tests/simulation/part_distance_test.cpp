// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/part_distance.h"

#include <gtest/gtest.h>

#include "revolved_surfaces.h"
#include "test_meshes.h"

namespace endmill {
namespace {

TEST(PartDistance, OfABoxIsToItsFaces)
{
    const Part part = test::box_mesh({0, 0, 0}, {2, 3, 4});
    const PartCharts charts = part_charts(part);
    const PartDistance distance_of{charts, 0.1};
    std::optional<std::size_t> hint;
    const auto distance = [&](const Vec3& place) { return distance_of(place, hint); };
    EXPECT_EQ(distance({1, 1, 6}), 2);
    EXPECT_EQ(distance({5, 7, 4}), 5);
}

TEST(PartDistance, OfACylinderIsToItsRadiusWithinTheTolerance)
{
    const Part part =
        std::vector<Surface>{nurbs_surface(test::cylinder(20, 4, 0.3, 2.3))};
    const PartCharts charts = part_charts(part);
    const PartDistance distance_of{charts, 0.01};
    std::optional<std::size_t> hint;
    const auto distance = [&](const Vec3& place) { return distance_of(place, hint); };
    EXPECT_GE(distance({2, 0, 25}), 5 - 1e-12);
    EXPECT_LE(distance({2, 0, 25}), 5.02);
    EXPECT_GE(distance({2, 0, 20}), 0);
    EXPECT_LE(distance({2, 0, 20}), 0.02);
}

}  // namespace
}  // namespace endmill
