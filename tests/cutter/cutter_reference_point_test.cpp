// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

const std::array cutters{Cutter::ball(10), Cutter{10, 3}, Cutter::flat(10)};

Vec3 random_normal(test::Random& random)
{
    const double z = random.uniform(0.01, 0.99);
    const double a = random.uniform(0, 2 * std::numbers::pi);
    const double level = std::sqrt(1 - z * z);
    return Vec3{level * std::cos(a), level * std::sin(a), z}.normalized();
}

// Smallest distance between the cutter's surface, with its tip at `tip`, and the plane
// through the origin. It is sampled on the profile in the vertical section along the
// slope.
double gap_to_plane(const Cutter& cutter, const Vec3& normal, const Vec3& tip)
{
    const Vec3 level = Vec3{normal.x(), normal.y(), 0}.normalized();
    double least = std::numeric_limits<double>::infinity();
    constexpr int samples = 4000;
    for (int k = -samples; k <= samples; ++k) {
        // More samples towards the rim, where the profile is steep.
        const double share = std::sin(std::numbers::pi / 2 * k / samples);
        const double across = share * cutter.radius();
        const Vec3 point =
            tip + across * level +
            cutter.profile(std::min(std::abs(across), cutter.radius())) * Vec3::UnitZ();
        least = std::min(least, point.dot(normal));
    }
    return least;
}

TEST(ReferencePoint, PutsEachCutterOnThePlane)
{
    test::Random random{1};
    for (const Cutter& cutter : cutters)
        for (int k = 0; k < 5; ++k) {
            const Vec3 normal = random_normal(random);
            const Vec3 tip =
                control_point(cutter, {Vec3::Zero(), normal}, ControlPoint::Tip);
            EXPECT_NEAR(gap_to_plane(cutter, normal, tip), 0, 1e-6);
        }
}

TEST(ReferencePoint, OnAPlaneLiesAboveItByTheFormulaOfTheSlope)
{
    for (const Cutter& cutter : cutters)
        for (const double slope : {0.1, 0.7, 1.2, 1.5}) {
            const Vec3 normal{-std::sin(slope), 0, std::cos(slope)};
            const Vec3 contact{3, -2, 5};
            const double above =
                (control_point(cutter, {contact, normal}) - contact).dot(normal);
            EXPECT_NEAR(above,
                        cutter.corner_radius() + cutter.flat_radius() * std::sin(slope),
                        1e-12 * cutter.radius());
        }
}

// On a sphere of radius S the centres of the corner lie on a sphere of radius S + r. On a
// cylinder about y they have no y component.
TEST(ReferencePoint, OnSphereAndCylinderLiesOnTheirOffsets)
{
    test::Random random{2};
    constexpr double size = 25;
    for (const Cutter& cutter : cutters)
        for (int k = 0; k < 20; ++k) {
            const Vec3 normal = random_normal(random);
            const Vec3 on_sphere = control_point(cutter, {size * normal, normal});
            const double level = std::hypot(normal.x(), normal.y());
            const double far = size + cutter.corner_radius();
            EXPECT_NEAR(std::hypot(on_sphere.x(), on_sphere.y()),
                        far * level + cutter.flat_radius(), 1e-12 * far);
            EXPECT_NEAR(on_sphere.z(), far * normal.z(), 1e-12 * far);

            const Vec3 bent = Vec3{normal.x(), 0, normal.z()}.normalized();
            const Vec3 contact = size * bent + Vec3{0, 7, 0};
            const Vec3 on_cylinder = control_point(cutter, {contact, bent});
            EXPECT_EQ(on_cylinder.y(), 7);
            EXPECT_NEAR(on_cylinder.x(),
                        far * bent.x() + std::copysign(cutter.flat_radius(), bent.x()),
                        1e-12 * far);
            EXPECT_NEAR(on_cylinder.z(), far * bent.z(), 1e-12 * far);
        }
}

TEST(ReferencePoint, OfABullNoseIsThatOfBallAndFlatAtItsLimits)
{
    test::Random random{3};
    for (int k = 0; k < 100; ++k) {
        const CutterContact contact{{1, 2, 3}, random_normal(random)};
        const Vec3 ball = contact.point + 10 * contact.normal;
        const Vec3 level = Vec3{contact.normal.x(), contact.normal.y(), 0}.normalized();
        EXPECT_LE((control_point(Cutter{10, 10}, contact) - ball).norm(), 1e-14 * 10);
        EXPECT_LE((control_point(Cutter{10, 10 * (1 - 1e-15)}, contact) - ball).norm(),
                  3e-14 * 10);
        EXPECT_LE(
            (control_point(Cutter{10, 0}, contact) - contact.point - 10 * level).norm(),
            1e-14 * 10);
    }
}

TEST(ReferencePoint, LiesTheCornerRadiusAboveTheTip)
{
    test::Random random{4};
    for (const Cutter& cutter : cutters) {
        const CutterContact contact{{1, 2, 3}, random_normal(random)};
        const Vec3 apart = control_point(cutter, contact) -
                           control_point(cutter, contact, ControlPoint::Tip);
        EXPECT_LE((apart - Vec3{0, 0, cutter.corner_radius()}).norm(), 1e-14 * 10);
    }
}

// Of the disc of contacts with a level plane the centre is taken, and `is_level` holds.
TEST(ReferencePoint, OnALevelPlaneIsTheMiddleOfTheDisc)
{
    for (const Cutter& cutter : cutters)
        EXPECT_EQ(control_offset(cutter, Vec3::UnitZ()),
                  Vec3(0, 0, cutter.corner_radius()));
    EXPECT_TRUE(is_level(Vec3::UnitZ()));
    EXPECT_TRUE(is_level({1e-13, 0, 1}));
    EXPECT_FALSE(is_level({1e-11, 0, 1}));
    EXPECT_TRUE(is_level(Vec3::UnitX(), Vec3::UnitX()));
}

// Rotating everything rotates the control point.
TEST(ReferencePoint, FollowsTheAxis)
{
    const Eigen::AngleAxisd turn{0.7, Vec3{1, 2, -1}.normalized()};
    test::Random random{5};
    for (const Cutter& cutter : cutters)
        for (const ControlPoint which : {ControlPoint::Reference, ControlPoint::Tip}) {
            const Vec3 normal = random_normal(random);
            const Vec3 turned =
                control_offset(cutter, turn * normal, which, turn * Vec3::UnitZ());
            EXPECT_LE((turned - turn * control_offset(cutter, normal, which)).norm(),
                      1e-14 * 10);
        }
}

// A cutter set to the ball's reference points leaves stock on a slope, and set to the
// ball's tips it gouges. Both depths are simulated with the cutter's profile.
TEST(ReferencePoint, OfTheBallUsedForAnotherCutterLeavesStockOrGouges)
{
    const Cutter ball = Cutter::ball(10);
    for (const double r : {0.0, 3.0, 7.0})
        for (const double slope : {0.2, std::numbers::pi / 4, 1.3}) {
            const Cutter cutter{10, r};
            const Vec3 normal{-std::sin(slope), 0, std::cos(slope)};
            const Vec3 reference = control_offset(ball, normal);
            EXPECT_NEAR(gap_to_plane(cutter, normal, reference - r * Vec3::UnitZ()),
                        (10 - r) * (1 - std::sin(slope)), 1e-6);
            const Vec3 tip = control_offset(ball, normal, ControlPoint::Tip);
            EXPECT_NEAR(gap_to_plane(cutter, normal, tip),
                        -(10 - r) * (std::sin(slope) + std::cos(slope) - 1), 1e-6);
        }
}

TEST(ReferencePoint, WithAllowanceKeepsThatDistance)
{
    test::Random random{6};
    for (const Cutter& cutter : cutters) {
        const Vec3 normal = random_normal(random);
        const Cutter larger = with_allowance(cutter, 0.5);
        const Vec3 tip =
            control_offset(larger, normal) - cutter.corner_radius() * Vec3::UnitZ();
        EXPECT_NEAR(gap_to_plane(cutter, normal, tip), 0.5, 1e-6);
    }
    EXPECT_EQ(with_allowance(cutters[1], 0), cutters[1]);
    EXPECT_THROW(with_allowance(cutters[1], -1), DomainError);
    EXPECT_THROW(with_allowance(cutters[1], NAN), DomainError);
}

}  // namespace
}  // namespace endmill
