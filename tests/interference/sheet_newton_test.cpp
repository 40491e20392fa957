// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/sheet_newton.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/interference/offset_jet.h"

namespace endmill {
namespace {

constexpr double p = 4;  // mm, the trough's parameter
constexpr double beta = 25 * 3.14159265358979323846 / 180;

// The inclined trough of acceptance A3, z = x^2 / (2 p) + y tan(beta), offset by a ball.
SmoothSheet trough(double radius)
{
    return [radius](const Eigen::Vector2d& at) {
        const SurfaceJet jet{
            {at.x(), at.y(), at.x() * at.x() / (2 * p) + at.y() * std::tan(beta)},
            {1, 0, at.x() / p},
            {0, 1, std::tan(beta)},
            {0, 0, 1 / p},
            Vec3::Zero(),
            Vec3::Zero()};
        return offset_jet(jet, 1, Cutter::ball(radius));
    };
}

// The offset in closed form, spec of interference, A3.
Vec3 trough_point(double radius, double x, double y)
{
    const double w = std::sqrt(1 + std::tan(beta) * std::tan(beta) + x * x / (p * p));
    return {x - radius * x / (p * w), y - radius * std::tan(beta) / w,
            x * x / (2 * p) + y * std::tan(beta) + radius / w};
}

const DriveFrame along_x{Angle::degrees(0)};

TEST(SheetNewton, FindsTheHeightOfTheClosedForm)
{
    const SmoothSheet sheet = trough(2);
    const Vec3 expected = trough_point(2, 3.1, 0.7);
    const auto z =
        height_on_sheet({sheet, {2.9, 0.5}, {1, 1}}, along_x, expected.x(), expected.y());
    ASSERT_TRUE(z);
    EXPECT_NEAR(*z, expected.z(), 1e-9);
}

TEST(SheetNewton, TurnsWithTheFeed)
{
    const SmoothSheet sheet = trough(2);
    const DriveFrame frame{Angle::degrees(-15)};
    const Vec3 expected = trough_point(2, -1.3, 4);
    const auto z = height_on_sheet({sheet, {-1, 3.8}, {1, 1}}, frame,
                                   frame.along(expected), frame.across(expected));
    ASSERT_TRUE(z);
    EXPECT_NEAR(*z, expected.z(), 1e-9);
}

TEST(SheetNewton, FindsTheCrossingOfTheInclinedTrough)
{
    // By symmetry the two contacts are at +-x where the offset's x vanishes: w = R / p.
    const double radius = 7;
    const double expected =
        radius * radius / (2 * p) + p / (2 * std::cos(beta) * std::cos(beta));
    const SmoothSheet sheet = trough(radius);
    const auto crossing = crossing_of_sheets({sheet, {5.0, 1.6}, {2, 2}},
                                             {sheet, {-5.6, 2.0}, {2, 2}}, along_x, 0);
    ASSERT_TRUE(crossing);
    EXPECT_NEAR(crossing->x(), 0, 1e-9);
    EXPECT_NEAR(crossing->y(), expected, 1e-9);
    EXPECT_NEAR(expected, 8.559885664108, 1e-12);  // as printed in the specification
}

TEST(SheetNewton, StaysWithinItsReach)
{
    const SmoothSheet sheet = trough(2);
    const Vec3 far = trough_point(2, 9, 0);
    EXPECT_FALSE(height_on_sheet({sheet, {1, 0}, {0.5, 0.5}}, along_x, far.x(), far.y()));
}

TEST(SheetNewton, IsNoneWhereNothingIsDetermined)
{
    const SmoothSheet sheet = trough(7);
    // One sheet from one start: the two contacts are the same, and anywhere.
    EXPECT_FALSE(
        crossing_of_sheets({sheet, {1, 0}, {9, 9}}, {sheet, {1, 0}, {9, 9}}, along_x, 3));
    const SmoothSheet nowhere = [](const Eigen::Vector2d&) {
        return std::optional<SurfaceTangents>{};
    };
    EXPECT_FALSE(height_on_sheet({nowhere, {0, 0}, {1, 1}}, along_x, 0, 0));
}

}  // namespace
}  // namespace endmill
