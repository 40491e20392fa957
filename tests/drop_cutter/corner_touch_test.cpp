// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/corner_touch.h"

#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

const CutterShape<double> shape{5, 2, 3};
constexpr double none = -1e9;

// Closed form: across the axis the line is tangent to the tube where the tube has the
// line's slope.
TEST(CornerTouch, IsWhereTheTubeHasTheLinesSlope)
{
    for (const double m : {0.1, 1.0, 7.0}) {
        const RisingLine<double> line{m, 0, 0};
        const CornerTouch<double> touch{shape, line};
        const double t = touch.highest(-5, 5, none).value();
        EXPECT_NEAR(t, 3 + 2 * m / std::sqrt(1 + m * m), 1e-12);
        EXPECT_NEAR(touch.profile(t), 2 - 2 / std::sqrt(1 + m * m), 1e-12);
    }
}

// Second route: no nearby position is higher.
TEST(CornerTouch, IsTheHighestTip)
{
    test::Random random{1};
    for (int k = 0; k < 500; ++k) {
        const double e = random.uniform(0, 4.99);
        const double half = std::sqrt(25 - e * e);
        const RisingLine<double> line{random.log_uniform(1e-3, 1e2), e * e, 1};
        const CornerTouch<double> touch{shape, line};
        const double low = random.uniform(-half, half);
        const double high = random.uniform(low, half);
        const double t = touch.highest(low, high, none).value();
        const auto tip = [&](double at) {
            return line.height + line.slope * at - touch.profile(at);
        };
        ASSERT_TRUE(low <= t && t <= high);
        for (int i = 0; i <= 1000; ++i)
            EXPECT_LE(tip(low + i / 1000.0 * (high - low)), tip(t) + 1e-12);
        EXPECT_TRUE(touch.highest(low, high, tip(t)).has_value());
    }
}

TEST(CornerTouch, OfALevelLineIsItsNearestPoint)
{
    const RisingLine<double> line{0, 4, 0};
    const CornerTouch<double> touch{shape, line};
    EXPECT_EQ(touch.highest(-3, 4, none), 0);
    EXPECT_EQ(touch.highest(1, 4, none), 1);
    EXPECT_EQ(touch.highest(-3, -1, none), -1);
}

TEST(CornerTouch, AgreesWithTwiceTheDigits)
{
    const CutterShape<DoubleDouble> exact{5, 2, 3};
    for (const double m : {0.3, 2.0, 50.0}) {
        const RisingLine<double> line{m, 2.25, 0};
        const RisingLine<DoubleDouble> exact_line{m, 2.25, 0};
        const double t = CornerTouch<double>{shape, line}.highest(-4, 4.7, none).value();
        const auto finer =
            CornerTouch<DoubleDouble>{exact, exact_line}.highest(-4, 4.7, none);
        EXPECT_NEAR(t, finer->value(), 1e-12);
    }
}

}  // namespace
}  // namespace endmill
