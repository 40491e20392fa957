// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/ball_clearance.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/drop_cutter/detail/triangle_drop.h"
#include "random.h"

namespace endmill {
namespace {

using Corners = std::array<Vec3, 3>;

// The greatest rise of a triangle above the tip of a ball on a move, from many places.
double greatest_rise(const Corners& corners, const Vec3& from, const Vec3& to,
                     double radius)
{
    const TriangleDrop drop{Cutter::ball(radius)};
    double greatest = -1e9;
    for (int k = 0; k <= 200; ++k) {
        const Vec3 centre = from + k / 200.0 * (to - from);
        greatest = std::max(greatest, drop(corners, centre.x(), centre.y()).tip_z -
                                          (centre.z() - radius));
    }
    return greatest;
}

TEST(BallClearance, IsProvedOnlyWhereTheDropCutterFindsNoContact)
{
    test::Random random{5};
    int proved = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const double size = random.log_uniform(0.05, 5);
        Corners corners;
        for (Vec3& corner : corners)
            corner = {random.uniform(-size, size), random.uniform(-size, size),
                      random.uniform(-size, size)};
        const double radius = random.log_uniform(0.3, 5);
        const auto centre = [&] {
            return Vec3{random.uniform(-6, 6), random.uniform(-6, 6),
                        random.uniform(-1, 7)};
        };
        const Vec3 from = centre();
        const Vec3 to = trial % 10 == 0 ? from : centre();
        if (!is_ball_proved_clear(corners, from, to, radius))
            continue;
        ++proved;
        ASSERT_LE(greatest_rise(corners, from, to, radius), 1e-9);
    }
    EXPECT_GT(proved, 1000);
}

// A ball on a straight move over a convex cylinder about the y axis, whose ends touch it and
// whose middle is lowered by 0.001 mm less than a smaller ball allows.
TEST(BallClearance, IsProvedForSmallFacetsCloseToTheBall)
{
    const double part_radius = 60;
    const double radius = 5;
    const auto point = [&](double angle, double y) {
        return Vec3{part_radius * std::sin(angle), y, part_radius * std::cos(angle)};
    };
    // on facets of 0.2 mm with a sagitta of 0.00008 mm
    const double step = 0.2 / part_radius;
    const double half_turn =
        std::acos((part_radius + radius) / (part_radius + radius + 0.004));
    const Vec3 from = (part_radius + radius + 0.005) / part_radius * point(-half_turn, 0);
    const Vec3 to = (part_radius + radius + 0.005) / part_radius * point(half_turn, 0);
    int facets = 0;
    int proved = 0;
    for (int k = -30; k < 30; ++k)
        for (int j = -10; j < 10; ++j) {
            const Corners facet{point(k * step, 0.2 * j), point(k * step, 0.2 * j + 0.2),
                                point(k * step + step, 0.2 * j)};
            ++facets;
            proved += is_ball_proved_clear(facet, from, to, radius) ? 1 : 0;
        }
    EXPECT_GT(proved, 0.9 * facets);
}

TEST(BallClearance, IsNotProvedForAContactOrBesideTheShank)
{
    const Corners level{Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{0, 1, 0}};
    EXPECT_TRUE(is_ball_proved_clear(level, {-3, 0, 2.001}, {3, 0, 2.001}, 2));
    EXPECT_FALSE(is_ball_proved_clear(level, {-3, 0, 1.999}, {3, 0, 1.999}, 2));
    const Corners wall{Vec3{1, -9, 0}, Vec3{1, 9, 0}, Vec3{1, 0, 9}};
    EXPECT_FALSE(is_ball_proved_clear(wall, {0, 0, 2}, {0, 0, 2}, 2));
    EXPECT_FALSE(is_ball_proved_clear(wall, {-5, 0, 2}, {-5, 0, 2}, 2));
}

}  // namespace
}  // namespace endmill
