// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/patch_sides.h"

#include <gtest/gtest.h>

#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(PatchSides, AreTheBordersOfAllPatches)
{
    const std::vector<Surface> plane{test::plane(30, 20, {3, 2})};
    const auto sides = patch_sides(plane);
    EXPECT_EQ(sides.size(), 2U * (3 + 2));
    for (const PatchSide& side : sides) {
        EXPECT_EQ((side.ends[1] - side.ends[0]).norm(), 10);
        EXPECT_EQ(side.tangents(0.5).point, (side.ends[0] + side.ends[1]) / 2);
    }
    EXPECT_TRUE(meeting_sides(sides, same_end_mm(plane)).empty());
}

TEST(PatchSides, ThatArePolesAreLeftOut)
{
    const double top = std::numbers::pi / 2;
    const std::vector<Surface> cap{nurbs_surface(test::torus(0, 9, {0, 1, 0.3, top}))};
    EXPECT_EQ(patch_sides(cap).size(), 3U);
}

TEST(PatchSides, OfAClosedSurfaceMeetAtItsSeam)
{
    const double turn = 2 * std::numbers::pi;
    const std::vector<Surface> tube{nurbs_surface(test::cylinder(5, 9, 0, turn, 4))};
    const auto sides = patch_sides(tube);
    const auto pairs = meeting_sides(sides, same_end_mm(tube));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(sides[pairs[0].first].along, Parameter::U);
    EXPECT_NE(sides[pairs[0].first].end, sides[pairs[0].second].end);
}

TEST(PatchSides, BetweenTheSameEndsButOnTwoCurvesDoNotMeet)
{
    // a lens: the parabolas y = +-(1 - x^2) between two poles
    const std::vector<Surface> lens{test::polynomial_surface(
        {test::monomial(1, 0, 1), test::monomial(0, 1, 1) + test::monomial(2, 1, -1),
         test::monomial(0, 0, 0)},
        {{-1, 1}, {-1, 1}})};
    const auto sides = patch_sides(lens);
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_LT((sides[0].ends[0] - sides[1].ends[0]).norm(), 1e-12);
    EXPECT_LT((sides[0].ends[1] - sides[1].ends[1]).norm(), 1e-12);
    EXPECT_TRUE(meeting_sides(sides, same_end_mm(lens)).empty());
}

}  // namespace
}  // namespace endmill
