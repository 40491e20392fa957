// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/arc.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::numbers::pi;

// Point of a circle in a plane, by its angle from the first axis of the plane.
Vec3 on_circle(ArcPlane plane, double radius, double angle, double height = 0)
{
    const PlaneAxes axes = plane_axes(plane);
    Vec3 point;
    point[axes.first] = radius * std::cos(angle);
    point[axes.second] = radius * std::sin(angle);
    point[axes.normal] = height;
    return point;
}

constexpr ArcPlane planes[] = {ArcPlane::Xy, ArcPlane::Zx, ArcPlane::Yz};

TEST(PlaneAxesOf, AreRightHanded)
{
    for (const ArcPlane plane : planes) {
        const PlaneAxes axes = plane_axes(plane);
        const Eigen::Vector3d first = Eigen::Vector3d::Unit(axes.first);
        const Eigen::Vector3d second = Eigen::Vector3d::Unit(axes.second);
        EXPECT_EQ(first.cross(second).eval(), Eigen::Vector3d::Unit(axes.normal));
    }
    EXPECT_EQ(plane_axes(ArcPlane::Xy).normal, 2);
    EXPECT_EQ(plane_axes(ArcPlane::Zx).normal, 1);
    EXPECT_EQ(plane_axes(ArcPlane::Yz).normal, 0);
}

TEST(ArcAngle, IsTheAngleBetweenTheEndsInTheSenseOfTheArc)
{
    for (const ArcPlane plane : planes)
        for (double from = -3; from < 3; from += 0.7)
            for (double angle = 0.1; angle < 2 * pi; angle += 0.3) {
                Arc arc{on_circle(plane, 4, from), on_circle(plane, 4, from + angle, 1),
                        Vec3::Zero(), plane, false};
                EXPECT_NEAR(arc_angle(arc), angle, 1e-14);
                arc.clockwise = true;
                EXPECT_NEAR(arc_angle(arc), 2 * pi - angle, 1e-14);
                arc.turns = 3;
                EXPECT_NEAR(arc_angle(arc), 6 * pi - angle, 1e-13);
            }
}

TEST(ArcAngle, IsAFullTurnWhereTheEndsMeet)
{
    Arc arc{{4, 0, 0}, {4, 0, -1}, Vec3::Zero()};
    EXPECT_DOUBLE_EQ(arc_angle(arc), 2 * pi);
    arc.end.y() = 1e-12;  // rounding of summed increments, in either direction
    EXPECT_DOUBLE_EQ(arc_angle(arc), 2 * pi);
    arc.end.y() = -1e-12;
    EXPECT_DOUBLE_EQ(arc_angle(arc), 2 * pi);
    arc.end.y() = 1e-4;
    arc.clockwise = false;
    EXPECT_NEAR(arc_angle(arc), 1e-4 / 4, 1e-12);
}

TEST(CentreOfRadius, GivesArcsOfThatRadiusBelowAndAboveHalfATurn)
{
    for (const ArcPlane plane : planes)
        for (const bool clockwise : {false, true})
            for (const double radius : {2.6, 7.0, -7.0, -300.0}) {
                Arc arc{on_circle(plane, 2.5, 0.3), on_circle(plane, 2.5, 0.3 + pi),
                        Vec3::Zero(), plane, clockwise};
                const auto centre = centre_of_radius(arc, radius, 0);
                ASSERT_TRUE(centre);
                arc.centre = *centre;
                EXPECT_NEAR(arc_radii(arc).start, std::abs(radius), 1e-12);
                EXPECT_NEAR(arc_radii(arc).end, std::abs(radius), 1e-12);
                EXPECT_EQ(arc_angle(arc) < pi, radius > 0);
                // The chord 2 r sin(angle / 2) equals the distance of the ends.
                EXPECT_NEAR(2 * std::abs(radius) * std::sin(arc_angle(arc) / 2), 5,
                            1e-10);
            }
}

TEST(CentreOfRadius, IsTheMiddleForARadiusThatIsSlightlyTooSmall)
{
    const Arc arc{{0, 0, 0}, {10, 0, 0}, Vec3::Zero()};
    EXPECT_FALSE(centre_of_radius(arc, 4.98, 0.01));
    const auto centre = centre_of_radius(arc, 4.995, 0.01);
    ASSERT_TRUE(centre);
    EXPECT_EQ(*centre, Vec3(5, 0, 0));
}

TEST(ArcChords, HaveTheirEndsOnTheCircleAndTheirMiddlesWithinTheTolerance)
{
    for (const ArcPlane plane : planes)
        for (const double tolerance : {1e-4, 1e-3, 0.1})
            for (const double radius : {0.3, 5.0, 200.0}) {
                const PlaneAxes axes = plane_axes(plane);
                const Vec3 centre{3, -2, 7};
                const Arc arc{centre + on_circle(plane, radius, 2),
                              centre + on_circle(plane, radius, 5.5), centre, plane,
                              true};
                const ArcChords chords{arc, tolerance};
                const auto count = static_cast<std::size_t>(chords.count());
                Vec3 before = arc.start;
                double travelled = 0;
                for (std::size_t i = 1; i <= count; ++i) {
                    const Vec3 point = chords.end(i);
                    EXPECT_NEAR((point - centre).norm(), radius, 2e-15 * (radius + 10));
                    EXPECT_NEAR(point[axes.normal], centre[axes.normal], 1e-14);
                    const Vec3 middle = (point + before) / 2;
                    EXPECT_LE(radius - (middle - centre).norm(), tolerance * (1 + 1e-9));
                    travelled += (point - before).norm();
                    before = point;
                }
                EXPECT_EQ(before, arc.end);
                const double length = radius * (2 * pi - 3.5);
                EXPECT_LE(travelled, length);
                EXPECT_GT(travelled, 0.9 * length);
            }
}

TEST(ArcChords, HaveTheLeastNumberOfTheFormula)
{
    const Arc quarter{{5, 0, 0}, {0, 5, 0}, Vec3::Zero(), ArcPlane::Xy, false};
    const double step = 2 * std::acos(1 - 0.001 / 5);
    EXPECT_EQ(ArcChords(quarter, 0.001).count(), std::ceil(pi / 2 / step));
    EXPECT_EQ(ArcChords(quarter, 1e9).count(), 1);
    const Arc circle{{5, 0, 0}, {5, 0, 0}, Vec3::Zero()};
    EXPECT_EQ(ArcChords(circle, 1e9).count(), 2);  // one chord would be a point
}

// Seen from +normal, a clockwise arc from the first axis goes to the negative second
// axis: for G18 from +z to -x.
TEST(ArcChords, FollowTheSenseOfTheArc)
{
    for (const ArcPlane plane : planes) {
        const PlaneAxes axes = plane_axes(plane);
        Arc arc{on_circle(plane, 5, 0), on_circle(plane, 5, 0), Vec3::Zero(), plane,
                true};
        EXPECT_LT(ArcChords(arc, 0.01).end(1)[axes.second], 0);
        arc.clockwise = false;
        EXPECT_GT(ArcChords(arc, 0.01).end(1)[axes.second], 0);
    }
    const Arc g18{{0, 0, 5}, {-5, 0, 0}, Vec3::Zero(), ArcPlane::Zx, true};
    EXPECT_NEAR(arc_angle(g18), pi / 2, 1e-15);
}

TEST(ArcChords, RiseAndWidenEvenlyWithTheAngle)
{
    const Arc helix{{5, 0, 0}, {0, 5.004, -3}, {0, 0, 99}, ArcPlane::Xy, false, 2};
    const ArcChords chords{helix, 0.001};
    const auto count = static_cast<std::size_t>(chords.count());
    ASSERT_GT(count, 100U);
    for (std::size_t i = 1; i <= count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        const Vec3 point = chords.end(i);
        EXPECT_NEAR(point.z(), -3 * part, 1e-13);
        EXPECT_NEAR(std::hypot(point.x(), point.y()), 5 + 0.004 * part, 1e-13);
        const double angle = std::atan2(point.y(), point.x());
        EXPECT_NEAR(std::remainder(angle - 2.5 * pi * part, 2 * pi), 0, 1e-13);
    }
    EXPECT_EQ(chords.end(count), helix.end);
}

TEST(ArcChords, AreCountedWithoutComputingThem)
{
    const Arc many{{5, 0, 0}, {5, 0, 0}, Vec3::Zero(), ArcPlane::Xy, true, 1e15};
    EXPECT_GT(ArcChords(many, 0.001).count(), 1e16);
}

}  // namespace
}  // namespace endmill
