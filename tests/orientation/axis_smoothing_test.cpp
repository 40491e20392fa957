// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/axis_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;

Vec3 leaning(double x_deg, double y_deg)
{
    return Vec3{std::tan(x_deg * degree), std::tan(y_deg * degree), 1}.normalized();
}

double bend(const std::vector<SmoothedRow>& rows, const std::vector<Vec3>& axes)
{
    double sum = 0;
    for (std::size_t k = 1; k < axes.size(); ++k)
        sum +=
            (axes[k] - axes[k - 1]).squaredNorm() / (rows[k].way_mm - rows[k - 1].way_mm);
    return sum;
}

SmoothingLimits limits_of(int rounds)
{
    SmoothingLimits limits;
    limits.is_allowed = [](std::size_t, const Vec3&) { return true; };
    limits.greatest_turn = 15 * degree;
    limits.rounds = rounds;
    return limits;
}

std::vector<SmoothedRow> random_rows(std::uint32_t seed)
{
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> lean{-6, 6};
    std::uniform_real_distribution<double> step{0.1, 2};
    std::vector<SmoothedRow> rows;
    double way = 0;
    for (int k = 0; k < 50; ++k) {
        way += step(random);
        rows.push_back({leaning(lean(random), lean(random)), way, k % 20 == 0});
    }
    return rows;
}

TEST(SmoothAxes, NeverRaisesTheSumAndNeverLeavesTheAllowedSet)
{
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const auto rows = random_rows(seed);
        double before = bend(rows, [&] {
            std::vector<Vec3> axes;
            axes.reserve(rows.size());
            for (const SmoothedRow& row : rows)
                axes.push_back(row.axis);
            return axes;
        }());
        for (int rounds = 0; rounds < 8; ++rounds) {
            SmoothingLimits limits = limits_of(rounds);
            // a band around the first axis of each row
            limits.is_allowed = [&](std::size_t row, const Vec3& axis) {
                return angle_between(axis, rows[row].axis) <=
                       static_cast<double>(row % 5) * degree;
            };
            const SmoothedAxes found = smooth_axes(rows, limits);
            const double after = bend(rows, found.axes);
            EXPECT_NEAR(after, found.smooth_bend, 1e-12);
            EXPECT_LE(after, before + 1e-15);
            before = after;
            for (std::size_t k = 0; k < rows.size(); ++k)
                EXPECT_LE(angle_between(found.axes[k], rows[k].axis),
                          static_cast<double>(k % 5) * degree + 1e-12);
        }
        EXPECT_LT(before, 0.9 * smooth_axes(rows, limits_of(0)).rough_bend);
    }
}

// With fixed ends the least sum turns evenly with the way; without fixed ends it is zero.
TEST(SmoothAxes, ApproachesAnEvenTurnBetweenFixedEnds)
{
    std::vector<SmoothedRow> rows;
    rows.reserve(7);
    for (int k = 0; k < 7; ++k)
        rows.push_back({leaning(k < 4 ? 0 : 12, 0), double(k * k)});
    SmoothingLimits limits = limits_of(100000);
    limits.is_allowed = [](std::size_t row, const Vec3&) { return row > 0 && row < 6; };
    const SmoothedAxes found = smooth_axes(rows, limits);
    for (int k = 0; k < 7; ++k)
        EXPECT_NEAR(angle_between(found.axes[static_cast<std::size_t>(k)], leaning(0, 0)),
                    12 * degree * k * k / 36, 0.5 * degree);
    EXPECT_GT(smooth_axes(rows, limits_of(100000)).rough_bend, 0);
    EXPECT_LT(smooth_axes(rows, limits_of(100000)).smooth_bend, 0.05 * found.smooth_bend);
}

TEST(SmoothAxes, SmoothsThePositionsOfAMachine)
{
    PartOnMachine setup;
    setup.machine.configuration = configuration_from_word("W/caxyBz/T");
    setup.machine.rotary = widest_limits(setup.machine.configuration);
    std::vector<SmoothedRow> rows;
    // tilt 20 degrees, azimuth in uneven steps past a half turn
    double azimuth = 170;
    for (int k = 0; k < 12; ++k) {
        azimuth += k % 2 == 0 ? 0 : 6;
        const double at = azimuth * degree;
        rows.push_back({{std::sin(20 * degree) * std::cos(at),
                         std::sin(20 * degree) * std::sin(at), std::cos(20 * degree)},
                        double(k)});
    }
    SmoothingLimits limits = limits_of(20);
    limits.machine = &setup;
    const SmoothedAxes found = smooth_axes(rows, limits);
    // six turns of C by 6 degrees and five by none
    EXPECT_NEAR(found.rough_bend, 6 * std::pow(6 * degree, 2), 1e-9);
    EXPECT_LT(found.smooth_bend, 0.6 * found.rough_bend);
    for (const Vec3& axis : found.axes)
        EXPECT_NEAR(std::acos(axis.z()), 20 * degree, 1e-9);
}

TEST(SmoothAxes, LeavesShortPathsAsTheyAre)
{
    EXPECT_TRUE(smooth_axes({}, limits_of(5)).axes.empty());
    const std::vector<SmoothedRow> one{{Vec3::UnitZ(), 0}};
    EXPECT_EQ(smooth_axes(one, limits_of(5)).axes.front(), Vec3::UnitZ());
    // rows at one place have no way between them
    const std::vector<SmoothedRow> two{{leaning(0, 0), 1}, {leaning(5, 0), 1}};
    const SmoothedAxes found = smooth_axes(two, limits_of(5));
    EXPECT_LE(found.smooth_bend, found.rough_bend);
    EXPECT_TRUE(std::isfinite(found.rough_bend));
}

}  // namespace
}  // namespace endmill
