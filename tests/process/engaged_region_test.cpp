// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/engaged_region.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

BallEngagement random_engagement(test::Random& random)
{
    return {random.uniform(-1.4, 1.4), random.uniform(-1.3, 1.3),
            random.uniform(0.02, 2.1), random.uniform(0.05, 1.5)};
}

// Whether the points at a small step to the right and left of a border are engaged.
struct Sides {
    bool right;
    bool left;
};

Sides sides(const EngagedRegion& region, const BorderArc& arc, double p)
{
    constexpr double step = 1e-6;
    const double way = arc.to > arc.from ? step : -step;
    const Vec3 at = region.point(arc.kind, p);
    const Vec3 along =
        (region.point(arc.kind, p + way) - region.point(arc.kind, p - way)).normalized();
    // Vector to the right of the border, seen along the feed.
    const Vec3 aside = along.cross(at).normalized();
    const auto is_in = [&](const Vec3& point) {
        return region.has(point.normalized()) &&
               -point.normalized().z() >= region.top_cosine;
    };
    return {is_in(at - step * aside), is_in(at + step * aside)};
}

TEST(Borders, HaveTheEngagedSideOnOneSide)
{
    test::Random random{6};
    int looked = 0;
    int wrong = 0;
    for (int n = 0; n < 2000; ++n) {
        const EngagedRegion region{random_engagement(random)};
        for (const BorderArc& arc :
             region.borders(n % 2 == 0 ? BorderSplit::AtAxis : BorderSplit::Whole)) {
            for (const double share : {0.1, 0.5, 0.9}) {
                const double p = arc.from + share * (arc.to - arc.from);
                const Sides found = sides(region, arc, p);
                ++looked;
                wrong += found.right == found.left ? 1 : 0;
                wrong += found.left ? 1 : 0;
            }
        }
    }
    EXPECT_GT(looked, 6000);
    // Exceptions lie beside borders as short as the step, or near corners.
    EXPECT_LE(wrong, looked / 300);
}

TEST(Borders, LieOnTheBallAndOnTheirSurface)
{
    test::Random random{7};
    for (int n = 0; n < 1000; ++n) {
        const EngagedRegion r{random_engagement(random)};
        for (const BorderArc& arc : r.borders(BorderSplit::AtAxis))
            for (const double share : {0.0, 0.3, 1.0}) {
                const Vec3 at = r.point(arc.kind, arc.from + share * (arc.to - arc.from));
                EXPECT_NEAR(at.norm(), 1, 1e-13);
                EXPECT_LE(at.z(), -r.top_cosine + 1e-12);
                const double tau = r.cos_lambda * at.x() + r.sin_lambda * at.z();
                const double w = r.cos_lambda * at.z() - r.sin_lambda * at.x();
                EXPECT_GE(tau, -1e-12);
                if (arc.kind == BorderKind::Front) {
                    EXPECT_NEAR(tau, 0, 1e-13);
                } else if (arc.kind == BorderKind::Wall) {
                    EXPECT_NEAR(at.y(), r.wall, 1e-13);
                } else {
                    EXPECT_NEAR(std::hypot(at.y() + r.pass.across, w + r.pass.rise), 1,
                                1e-13);
                }
            }
    }
}

TEST(Borders, SplitAtTheAxisAreOnOneSideOfIt)
{
    test::Random random{8};
    for (int n = 0; n < 1000; ++n) {
        const EngagedRegion region{random_engagement(random)};
        for (const BorderArc& arc : region.borders(BorderSplit::AtAxis)) {
            const double middle = region.point(arc.kind, (arc.from + arc.to) / 2).x();
            for (const double share : {0.01, 0.25, 0.75, 0.99}) {
                const double x =
                    region.point(arc.kind, arc.from + share * (arc.to - arc.from)).x();
                EXPECT_TRUE(x * middle >= 0 || std::abs(x) < 1e-9);
            }
        }
    }
}

TEST(Borders, MoveAtTheirRates)
{
    test::Random random{9};
    constexpr double step = 1e-6;
    for (int n = 0; n < 300; ++n) {
        const EngagedRegion region{random_engagement(random)};
        for (const BorderArc& arc : region.borders(BorderSplit::Whole)) {
            const double p = arc.from + 0.4 * (arc.to - arc.from);
            const BorderPoint point = region.moving_point(arc.kind, p);
            const Vec3 rate =
                (region.point(arc.kind, p + step) - region.point(arc.kind, p - step)) /
                (2 * step);
            EXPECT_NEAR(point.height, rate.z(), 1e-8);
            EXPECT_NEAR(point.turn, point.at.y() * rate.x() - point.at.x() * rate.y(),
                        1e-8);
            if (region.is_radial(arc.kind)) {
                EXPECT_NEAR(point.turn, 0, 1e-15);
            }
        }
    }
}

TEST(Borders, OfASlotAreTheFrontAlone)
{
    const EngagedRegion region{{0, 0.4, 0, 1, PreviousPass::None}};
    const auto arcs = region.borders(BorderSplit::AtAxis);
    ASSERT_EQ(arcs.size(), 1U);
    EXPECT_EQ(arcs[0].kind, BorderKind::Front);
    EXPECT_NEAR(arcs[0].from, 1, 1e-15);
    EXPECT_NEAR(arcs[0].to, -1, 1e-15);
}

TEST(Borders, PassTheAxisAtBesideAxis)
{
    test::Random random{10};
    for (int n = 0; n < 300; ++n) {
        BallEngagement engagement = random_engagement(random);
        engagement.pick_feed_ratio *= 0.45;
        const EngagedRegion region{engagement};
        const double p = region.beside_axis();
        if (p > region.pass.first && p < 1) {
            EXPECT_NEAR(region.point(BorderKind::PreviousBall, p).y(), 0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace endmill
