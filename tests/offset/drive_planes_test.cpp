// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/drive_planes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(DriveFrame, AtQuarterTurnsTakesCoordinatesAsTheyAre)
{
    const Vec3 point{0.1, 0.7, -3};
    const auto at = [&](double degrees) {
        const DriveFrame frame{Angle::degrees(degrees)};
        return std::pair{frame.along(point), frame.across(point)};
    };
    EXPECT_EQ(at(0), (std::pair{0.1, 0.7}));
    EXPECT_EQ(at(90), (std::pair{0.7, -0.1}));
    EXPECT_EQ(at(180), (std::pair{-0.1, -0.7}));
    EXPECT_EQ(at(-90), (std::pair{-0.7, 0.1}));
    EXPECT_EQ(at(360), (std::pair{0.1, 0.7}));
}

TEST(DriveFrame, GivesBackThePoint)
{
    for (const double degrees : {-15.0, 0.0, 33.0, 90.0, 200.0}) {
        const DriveFrame frame{Angle::degrees(degrees)};
        const Vec3 point{12, -5, 7};
        EXPECT_LE(
            (frame.point(frame.along(point), frame.across(point), 7) - point).norm(),
            1e-14 * 13);
    }
    EXPECT_THROW(DriveFrame{Angle::radians(NAN)}, DomainError);
}

TEST(DrivePlanes, StandInTheMiddlesOfEqualParts)
{
    const DriveFrame frame{Angle::degrees(0)};
    EXPECT_EQ(drive_planes(frame, {-2, 2}, 4).positions,
              (std::vector{-1.5, -0.5, 0.5, 1.5}));
    EXPECT_EQ(drive_planes(frame, {3, 3}, 2).positions, (std::vector{3.0, 3.0}));
}

TEST(DrivePlanes, ByPitchAreTheFewestThatKeepIt)
{
    const DriveFrame frame{Angle::degrees(0)};
    const auto count = [&](double width, double pitch) {
        return drive_planes_by_pitch(frame, {0, width}, pitch).positions.size();
    };
    EXPECT_EQ(count(10, 2.5), 4U);
    EXPECT_EQ(count(10, 2.4), 5U);
    EXPECT_EQ(count(0.3, 0.1),
              3U);  // in doubles 0.3 / 0.1 is slightly below 3 and 3 * 0.1 is above 0.3
    EXPECT_EQ(count(3 * 0.1, 0.1), 3U);
    EXPECT_EQ(count(0, 1), 1U);
    EXPECT_EQ(count(1, INFINITY), 1U);
}

TEST(DrivePlanes, RefuseInvalidArguments)
{
    const DriveFrame frame{Angle::degrees(0)};
    EXPECT_THROW(drive_planes(frame, {0, 1}, 0), DomainError);
    EXPECT_THROW(drive_planes(frame, {0, 1}, 10'000'001), DomainError);
    EXPECT_THROW(drive_planes(frame, {1, 0}, 3), DomainError);
    EXPECT_THROW(drive_planes(frame, {0, INFINITY}, 3), DomainError);
    EXPECT_THROW(drive_planes_by_pitch(frame, {0, 1}, 0), DomainError);
    EXPECT_THROW(drive_planes_by_pitch(frame, {0, 1}, NAN), DomainError);
    EXPECT_THROW(drive_planes_by_pitch(frame, {0, 1}, 1e-300), DomainError);
}

// A rectangle of 200 by 120 mm, across a feed at 30 degrees.
TEST(DrivePlanes, SpanTheExtentOfThePartAcrossTheFeed)
{
    const std::vector surfaces{test::plane(200, 120)};
    const Interval across = extent_across(surfaces, DriveFrame{Angle::degrees(30)});
    EXPECT_NEAR(across.low, -100, 1e-6);
    EXPECT_NEAR(across.high, 60 * std::sqrt(3), 1e-6);
}

// The corners of a rectangle as a mesh span what its surface spans.
TEST(DrivePlanes, SpanTheExtentOfAMeshAcrossTheFeed)
{
    const TriangleMesh mesh{{{0, 0, 1}, {200, 0, 2}, {200, 120, 3}, {0, 120, 4}},
                            {{0, 1, 2}, {0, 2, 3}}};
    const Interval across = extent_across(mesh, DriveFrame{Angle::degrees(30)});
    EXPECT_NEAR(across.low, -100, 1e-12);
    EXPECT_NEAR(across.high, 60 * std::sqrt(3), 1e-12);
    EXPECT_THROW(extent_across(TriangleMesh{}, DriveFrame{Angle::degrees(0)}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
