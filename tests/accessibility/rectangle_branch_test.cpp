// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/rectangle_branch.h"

#include <gtest/gtest.h>

#include "direction_sets.h"
#include "endmill/accessibility/rectangle_fit.h"

namespace endmill {
namespace {

using test::up;

// Where all directions are within 90 degrees the hulls' edges give the minimum exactly.
TEST(RectangleBranch, FindsTheMinimumOfTheHulls)
{
    test::Random random{41};
    for (int i = 0; i < 100; ++i) {
        const std::vector<Vec3> points = test::random_directions(random);
        const double exact =
            rectangle_fit(up, points, {RotaryFamily::AB, SetupMode::Corrected, {}})
                .least->area;
        const auto found = branch_rectangle(PolePoints{up, points}, {});
        ASSERT_TRUE(found);
        EXPECT_GE(found->area(), exact * (1 - 1e-12));
        EXPECT_LE(found->area(), exact * (1 + 1.1e-7));
        const auto coarse = coarse_rectangle(PolePoints{up, points}, {});
        EXPECT_GE(coarse->area(), exact * (1 - 1e-12));
    }
}

// Two directions 120 degrees from the tool axis, whose alpha jumps where R1 has their
// azimuth: no position of R1 in a search by hundredths of a degree is better.
TEST(RectangleBranch, CrossesTheJumpsOfLowDirections)
{
    const std::vector<Vec3> points =
        test::directions({{90, 120}, {270, 120}, {0, 30}, {180, 10}});
    const auto found = branch_rectangle(PolePoints{up, points}, {});
    ASSERT_TRUE(found);
    double searched = 1e9;
    for (double azimuth = 0; azimuth < 180; azimuth += 0.01)
        searched = std::min(
            searched, rectangle_about(up, test::direction({azimuth, 90}), points).area());
    EXPECT_LE(found->area(), searched * (1 + 1.1e-7));
    EXPECT_LE(searched, found->area() * 1.002);
    EXPECT_NEAR(rectangle_about(up, found->r1_axis, points).area(), found->area(), 1e-9);
}

TEST(RectangleBranch, StopsAtWhatIsWorthlessOrDoesNotFit)
{
    const std::vector<Vec3> points = test::directions({{90, 120}, {270, 120}, {0, 30}});
    const double area = branch_rectangle(PolePoints{up, points}, {})->area();
    BranchGoal goal;
    goal.worthless = 0.99 * area;
    EXPECT_FALSE(branch_rectangle(PolePoints{up, points}, goal));
    goal.worthless = 1.01 * area;
    EXPECT_TRUE(branch_rectangle(PolePoints{up, points}, goal));
    goal.limits = RotaryLimits{{-0.5, 0.5}, {-0.5, 0.5}};
    EXPECT_FALSE(branch_rectangle(PolePoints{up, points}, goal));
}

}  // namespace
}  // namespace endmill
