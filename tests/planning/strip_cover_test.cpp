// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/strip_cover.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/planning/detail/contact_line.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double height = 0.4;
using std::numbers::pi;

// The moves of a pass with contacts at `us`.
SweptPass pass_through(const MarchedSurface& marched, double v,
                       const std::vector<double>& us)
{
    const ContactLine line{marched, v, Parameter::U};
    SweptPass pass;
    for (std::size_t k = 1; k < us.size(); ++k)
        pass.push_back({us[k - 1], us[k],
                        ball_centre(line.at(us[k - 1]), BallCutter{radius}),
                        ball_centre(line.at(us[k]), BallCutter{radius})});
    return pass;
}

TEST(StripCover, DecidesAtTheScallopOfAPlane)
{
    const double interval = 2 * std::sqrt(2 * radius * height - height * height);
    for (const double share : {0.9, 0.9999, 1.0001, 1.1}) {
        const MarchedSurface plane{test::plane(40, share * interval), 1};
        const OffsetBounds bounds{plane.surface};
        const StripCover cover{plane, bounds, BallCutter{radius}, height};
        const auto found =
            cover.find_uncovered({0, 1}, pass_through(plane, 0, {0, 0.3, 1}),
                                 pass_through(plane, 1, {0, 0.6, 1}));
        EXPECT_EQ(found.has_value(), share > 1);
        if (found) {
            EXPECT_NEAR(found->v, 0.5, 0.1);
        }
    }
}

TEST(StripCover, FindsTheHoleThatAMissingMoveLeaves)
{
    const MarchedSurface plane{test::plane(40, 2), 1};
    const OffsetBounds bounds{plane.surface};
    const StripCover cover{plane, bounds, BallCutter{radius}, height};
    SweptPass holed = pass_through(plane, 0, {0, 0.3, 0.5, 1});
    holed.erase(holed.begin() + 1);  // 12 ... 20 mm; a ball covers some 2 mm around
    const auto found = cover.find_uncovered({0, 1}, holed, {});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->u, 0.4, 0.1);
    EXPECT_TRUE(cover.find_uncovered({0, 1}, {}, {}));
}

// On the line the remaining material is the sagitta of the chord between centres, in its
// middle.
TEST(StripCover, DecidesAtTheRemainingMaterialOfAChordInsideACylinder)
{
    constexpr double rho = 20;
    for (const double angle : {0.3, 0.9}) {
        const MarchedSurface marched{
            transposed(nurbs_surface(
                test::cylinder(rho, 30, 1.5 * pi - angle / 2, 1.5 * pi + angle / 2))),
            -1};  // inside
        const OffsetBounds bounds{marched.surface};
        const SweptSegment move = pass_through(marched, 0.5, {0, 1}).front();
        const double left = (rho - radius) * (1 - std::cos(angle / 2));
        for (const double share : {0.999, 1.001}) {
            const StripCover cover{marched, bounds, BallCutter{radius}, share * left};
            EXPECT_EQ(cover.covers_line(move, 0.5), share > 1);
        }
    }
}

TEST(StripCover, TreatsAHeightAboveTheRadiusAsTheRadius)
{
    const MarchedSurface plane{test::plane(40, 2), 1};
    const OffsetBounds bounds{plane.surface};
    const StripCover cover{plane, bounds, BallCutter{radius}, 100};
    EXPECT_FALSE(cover.find_uncovered({0, 1}, pass_through(plane, 0, {0, 1}), {}));
}

}  // namespace
}  // namespace endmill
