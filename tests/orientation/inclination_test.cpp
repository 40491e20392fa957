// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/inclination.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"

namespace endmill {
namespace {

Inclination inclined(double lead_deg, double tilt_deg)
{
    return {Angle::degrees(lead_deg), Angle::degrees(tilt_deg)};
}

Vec3 tip_on_level_ground(double corner_radius, const Inclination& inclination)
{
    const Vec3 axis = inclined_axis(Vec3::UnitZ(), Vec3::UnitX(), inclination);
    return control_point({5, corner_radius}, {Vec3::Zero(), Vec3::UnitZ()},
                         ControlPoint::Tip, axis);
}

// The numbers were computed by an independent program.
TEST(InclinedAxis, PutsTheTipWhereTheCutterTouches)
{
    const auto expect = [](const Vec3& found, double x, double y, double z) {
        EXPECT_NEAR((found - Vec3(x, y, z)).norm(), 0, 1e-6);
    };
    expect(tip_on_level_ground(5, inclined(10, 0)), -0.868241, 0, 0.075961);
    expect(tip_on_level_ground(0, inclined(10, 0)), -4.924039, 0, 0.868241);
    expect(tip_on_level_ground(1, inclined(10, 0)), -4.112879, 0, 0.709785);
    expect(inclined_axis(Vec3::UnitZ(), Vec3::UnitX(), inclined(10, 8)), 0.172008,
           0.137099, 0.975509);
    expect(tip_on_level_ground(1, inclined(10, 8)), -3.223376, -2.569181, 0.904337);
}

// On a plane 1 / kappa = R2 cos^2 + r sin^2, R2 = r + (R - r) / sin(lean), with the angle
// between lean and feed.
TEST(RemainingCurvature, OfABullNoseOnAPlaneIsThatOfItsEllipse)
{
    const Cutter bull{5, 1};
    const auto radius = [&](double lead_deg, double tilt_deg) {
        return 1 / *remaining_curvature(bull, {}, inclined(lead_deg, tilt_deg));
    };
    EXPECT_NEAR(radius(10, 0), 24.035082, 1e-6);
    EXPECT_NEAR(radius(10, 8), 12.120404, 1e-6);
    EXPECT_NEAR(radius(0, 8), 1, 1e-12);
    EXPECT_NEAR(radius(20, 20), 5.370042, 1e-6);
}

// The cut of an inclined cutter across the feed, sampled on the exact surface: the height of
// what two passes leave over a curved part, against half the curvature times y^2.
TEST(RemainingCurvature, IsThatOfTheSweptCutterOverCurvedParts)
{
    for (const ContactCurvature part :
         {ContactCurvature{0.01, -0.02, 0.004}, ContactCurvature{-0.01, 0.03, -0.01}})
        for (const Inclination& inclination : {inclined(25, 0), inclined(25, 10)}) {
            const Cutter bull{5, 1};
            const auto kappa = remaining_curvature(bull, part, inclination);
            ASSERT_TRUE(kappa);
            const Vec3 axis = inclined_axis(Vec3::UnitZ(), Vec3::UnitX(), inclination);
            const Vec3 tip = control_point(bull, {Vec3::Zero(), Vec3::UnitZ()},
                                           ControlPoint::Tip, axis);
            // height over (0, y) of the cutter that moves along x, rolling on the part: the
            // least over x of its height above the part
            const double y = 0.05;
            double least = std::numeric_limits<double>::infinity();
            for (int k = -400; k <= 400; ++k) {
                const double x = 0.001 * k;
                // lowest point of the cutter over (x, y), by bisection of its signed distance
                double low = -1;
                double high = 1;
                for (int halving = 0; halving < 60; ++halving) {
                    const double z = (low + high) / 2;
                    const Vec3 from_tip = Vec3(x, y, z) - tip;
                    const double up = from_tip.dot(axis);
                    const double away = (from_tip - up * axis).norm();
                    (away <= 5 && up >= bull.profile(away) ? high : low) = z;
                }
                const double ground =
                    -(part.along * x * x + 2 * part.mixed * x * y + part.across * y * y) /
                    2;
                least = std::min(least, high - ground);
            }
            EXPECT_NEAR(least, *kappa * y * y / 2, 0.02 * *kappa * y * y / 2);
        }
}

TEST(StripWidth, IsThatOfTheEllipseOnAPlane)
{
    EXPECT_NEAR(*strip_width(Cutter::flat(5), {}, inclined(10, 0), 0.01), 1.517731, 1e-6);
    EXPECT_NEAR(*strip_width(Cutter::ball(5), {}, inclined(10, 0), 0.01), 0.632456, 1e-6);
    EXPECT_EQ(*strip_width(Cutter::flat(5), {}, inclined(0.001, 0), 0.01), 10);
}

TEST(LeastLead, MakesTheCurvaturesEqual)
{
    const ContactCurvature part{-0.01, -0.04, 0.015};
    const auto lead = least_lead({5, 1}, part);
    ASSERT_TRUE(lead);
    EXPECT_NEAR(lead->degrees(), 9.651406, 1e-6);
    EXPECT_TRUE(remaining_curvature({5, 1}, part, inclined(lead->degrees() + 0.01, 0)));
    EXPECT_FALSE(remaining_curvature({5, 1}, part, inclined(lead->degrees() - 0.01, 0)));
    EXPECT_EQ(least_lead(Cutter::flat(5), {0, 0.1, 0})->radians(), 0);
    EXPECT_FALSE(least_lead(Cutter::flat(5), {0, -0.21, 0}));
    EXPECT_FALSE(least_lead(Cutter::ball(5), {0, -0.21, 0}));
    EXPECT_FALSE(least_lead({5, 1}, {-1.5, 0, 0}));
}

// In a bowl of radius 30 the rim of the cutter then lies on the bowl.
TEST(HeelLead, PutsTheRimOnTheBowl)
{
    EXPECT_NEAR(heel_lead(Cutter::flat(5), 30)->degrees(), 9.594068, 1e-6);
    EXPECT_NEAR(heel_lead({5, 1}, 30)->degrees(), 7.928142, 1e-6);
    EXPECT_EQ(heel_lead({5, 1}, std::numeric_limits<double>::infinity())->radians(), 0);
    EXPECT_FALSE(heel_lead(Cutter::flat(5), 4.9));
    EXPECT_FALSE(heel_lead(Cutter::ball(5), 4.9));
}

TEST(Inclination, BeyondItsRangeIsRefused)
{
    EXPECT_THROW(inclined_axis(Vec3::UnitZ(), Vec3::UnitX(), inclined(89.5, 0)),
                 DomainError);
    EXPECT_THROW(remaining_curvature({5, 1}, {}, inclined(0, -90)), DomainError);
    EXPECT_THROW(strip_width({5, 1}, {}, {}, 0), DomainError);
    EXPECT_THROW(heel_lead({5, 1}, 0), DomainError);
}

// The least gap over all places along the feed is where its derivative along the feed vanishes:
// the gap of the exact cutter over a part, from tiny steps.
TEST(ContactSkew, IsWhereTheCutterIsNearestBesideThePass)
{
    const ContactCurvature part{0.01, -0.02, 0.004};
    for (const Cutter& cutter : {Cutter{5, 1}, Cutter{5, 3}})
        for (const double tilt : {-10.0, 6.0}) {
            const Inclination inclination = inclined(25, tilt);
            const auto skew = contact_skew(cutter, part, inclination);
            ASSERT_TRUE(skew);
            const Vec3 axis = inclined_axis(Vec3::UnitZ(), Vec3::UnitX(), inclination);
            const Vec3 tip = control_point(cutter, {Vec3::Zero(), Vec3::UnitZ()},
                                           ControlPoint::Tip, axis);
            const CuttingBody body{cutter};
            const ToolFrame frame = frame_at({tip, axis});
            const double y = 0.02;
            double least = std::numeric_limits<double>::infinity();
            double place = 0;
            for (int k = -2000; k <= 2000; ++k) {
                const double x = 2e-5 * k;
                const double z =
                    -(part.along * x * x + 2 * part.mixed * x * y + part.across * y * y) /
                    2;
                const double gap = body.distance(frame.seen({x, y, z})).value;
                if (gap < least) {
                    least = gap;
                    place = x;
                }
            }
            EXPECT_NEAR(place / y, *skew, 0.03 * std::abs(*skew) + 0.01);
        }
    // a flat bottom touches along its rim
    EXPECT_NEAR(
        *contact_skew(Cutter::flat(5), {}, inclined(10, 5)),
        -std::tan(Angle::degrees(5).radians()) / std::tan(Angle::degrees(10).radians()),
        1e-12);
    EXPECT_NEAR(*contact_skew(Cutter::ball(5), {}, inclined(10, 5)), 0, 1e-12);
    EXPECT_FALSE(contact_skew(Cutter{5, 1}, {0, -0.5, 0}, inclined(5, 5)));
}

}  // namespace
}  // namespace endmill
