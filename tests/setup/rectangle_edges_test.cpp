// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_edges.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "direction_sets.h"

namespace endmill {
namespace {

using test::degree;
using test::up;

// Number of directions with this alpha or this beta about R1.
int at_border(const RectangleCandidate& rectangle, const std::vector<Vec3>& points,
              bool of_alpha)
{
    int count = 0;
    for (const Vec3& v : points) {
        const auto single = rectangle_about(up, rectangle.r1_axis, std::vector{v});
        const RotaryRange& own = of_alpha ? single.alpha : single.beta;
        const RotaryRange& all = of_alpha ? rectangle.alpha : rectangle.beta;
        if (std::abs(own.from + own.to - all.from) < 1e-9 ||
            std::abs(own.from + own.to - all.to) < 1e-9)
            ++count;
    }
    return count;
}

TEST(RectangleEdges, PassThroughTwoDirectionsOfAHull)
{
    test::Random random{51};
    for (int i = 0; i < 100; ++i) {
        std::vector<Vec3> points = test::random_directions(random);
        const RectangleImages images{PolePoints{up, points}, points,
                                     SetupMode::Corrected};
        points.push_back(up);
        for (const RectangleCandidate& found : images.at_edges()) {
            // One border passes through two directions, or one and the tool axis; each
            // other border through one.
            const bool of_alpha = found.origin == RectangleOrigin::GnomonicEdge;
            EXPECT_GE(at_border(found, points, of_alpha), 3);
            const auto measured = rectangle_about(up, found.r1_axis, points);
            EXPECT_NEAR(measured.area(), found.area(), 1e-12);
        }
    }
}

TEST(RectangleEdges, MeetALimitWithADirection)
{
    const std::vector<Vec3> points = test::ring(3, 30);
    const RotaryLimits limits{{-29.95 * degree, 20 * degree}, {-27 * degree, 3}};
    const RectangleImages images{PolePoints{up, points}, points, SetupMode::Corrected};
    const auto found = images.at_limits(limits);
    // Three directions at three limits below 90 degrees, twice each. The tool axis is not
    // a vertex.
    EXPECT_EQ(found.size(), 18U);
    for (const RectangleCandidate& rectangle : found) {
        const auto meets = [&](double limit) {
            return std::any_of(points.begin(), points.end(), [&](const Vec3& v) {
                const auto one = rectangle_about(up, rectangle.r1_axis, std::vector{v});
                return std::abs(std::abs(one.alpha.from + one.alpha.to) - limit) < 1e-9 ||
                       std::abs(std::abs(one.beta.from + one.beta.to) - limit) < 1e-9;
            });
        };
        EXPECT_TRUE(meets(29.95 * degree) || meets(20 * degree) || meets(27 * degree));
    }
}

TEST(RectangleEdges, FindAGreatCircleToRounding)
{
    const auto arc = great_circle_arc(
        PolePoints{up, test::directions({{30, 40}, {210, 100}, {30, 10}, {210, 5}})});
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->alpha.to - arc->alpha.from, 140 * degree, 1e-12);
    EXPECT_EQ(arc->area(), 0);
    EXPECT_FALSE(
        great_circle_arc(PolePoints{up, test::directions({{30, 40}, {30.001, 70}})}));
}

TEST(RectangleEdges, PutADirectionOppositeToTheToolAxisOnTheLargerSide)
{
    std::vector<Vec3> points = test::directions({{0, 40}, {180, 60}});
    points.push_back(-up);
    const auto arc = great_circle_arc(PolePoints{up, points});
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->alpha.to - arc->alpha.from, 220 * degree, 1e-12);
}

TEST(RectangleEdges, RecogniseLowDirections)
{
    EXPECT_FALSE(has_low_direction(PolePoints{up, test::directions({{0, 89.99}})}));
    EXPECT_TRUE(has_low_direction(PolePoints{up, test::directions({{0, 89.99999}})}));
    EXPECT_TRUE(has_low_direction(PolePoints{up, test::directions({{0, 120}})}));
}

}  // namespace
}  // namespace endmill
