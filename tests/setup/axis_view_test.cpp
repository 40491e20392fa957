// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_view.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

using std::numbers::pi;

TEST(AxisView, GivesAzimuthsAndLevelsAboutTheAxis)
{
    const std::vector<Vec3> cells{{0, 0, 1}, {0.6, 0, 0.8}, {0, -0.8, -0.6}};
    const AxisView ca = axis_view({RotaryFamily::CA, Vec3::UnitZ(), 0, {4, 4}}, cells);
    EXPECT_EQ(ca.free.size(), 2U);  // the pole appears on both sides
    ASSERT_EQ(ca.swept.size(), 4U);
    for (const SeenCell& cell : ca.swept) {
        const Vec3 zero = azimuth_zero(Vec3::UnitZ());
        const Vec3 quarter = Vec3::UnitZ().cross(zero);
        const double azimuth = cell.begin + (cell.side == 1 ? pi : 0);
        const Vec3 back = std::sin(cell.level) *
                              (std::cos(azimuth) * zero + std::sin(azimuth) * quarter) +
                          std::cos(cell.level) * Vec3::UnitZ();
        EXPECT_LT((back - cells[cell.cell]).norm(), 1e-15);
        EXPECT_EQ(cell.begin, cell.end);
    }
    const AxisView ab = axis_view({RotaryFamily::AB, Vec3::UnitZ(), 0, {4, 4}}, cells);
    ASSERT_EQ(ab.swept.size(), 2U);
    for (const SeenCell& cell : ab.swept) {
        EXPECT_EQ(cell.side, cells[cell.cell].z() < 0 ? 1 : 0);
        EXPECT_NEAR(std::sin(cell.level), std::abs(cells[cell.cell].z()), 1e-15);
    }
}

TEST(AxisView, IsValidForEveryAxisWithinTheRadius)
{
    const SphereGrid grid = sphere_grid("hex:3");
    std::mt19937 random{2};
    std::uniform_real_distribution<double> uniform{0, 1};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        for (int trial = 0; trial < 50; ++trial) {
            const Vec3 axis =
                Vec3{uniform(random), uniform(random), uniform(random) - 0.5}
                    .normalized();
            const double radius = 0.2 * uniform(random);
            const AxisView wide = axis_view({family, axis, radius, {4, 4}}, grid.centres);
            const Vec3 hinge =
                Eigen::AngleAxisd{2 * pi * uniform(random), axis} * azimuth_zero(axis);
            // Move the true axis to the given one, and the cells with it.
            const Eigen::AngleAxisd carry{radius * 0.999 * uniform(random), hinge};
            std::vector<Vec3> carried;
            for (const Vec3& cell : grid.centres)
                carried.push_back(carry * cell);
            const AxisView sharp = axis_view({family, axis, 0, {4, 4}}, carried);
            for (const SeenCell& cell : sharp.swept) {
                bool is_held = false;
                for (const auto* cells : {&wide.swept, &wide.free}) {
                    for (const SeenCell& other : *cells) {
                        if (other.cell != cell.cell)
                            continue;
                        const double level =
                            family == RotaryFamily::AB && other.side != cell.side
                                ? -other.level
                                : other.level;
                        if (family == RotaryFamily::CA && other.side != cell.side)
                            continue;
                        const double turn =
                            std::fmod(cell.begin - other.begin + 2 * pi, 2 * pi);
                        is_held =
                            is_held || (std::abs(level - cell.level) <= radius + 1e-12 &&
                                        (cells == &wide.free ||
                                         turn <= other.end - other.begin + 1e-12));
                    }
                }
                EXPECT_TRUE(is_held);
            }
        }
    }
}

TEST(AxisView, LeavesOutCellsBeyondTheReach)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const AxisView all =
        axis_view({RotaryFamily::CA, Vec3::UnitX(), 0.1, {4, 4}}, grid.centres);
    const AxisView near =
        axis_view({RotaryFamily::CA, Vec3::UnitX(), 0.1, {1, 0.5}}, grid.centres);
    const std::array<double, 2> reach{1.1, 0.6};
    std::size_t expected = 0;
    for (const SeenCell& cell : all.swept)
        expected += cell.level <= reach[cell.side] ? 1 : 0;
    EXPECT_EQ(near.swept.size(), expected);
    for (std::size_t k = 1; k < near.swept.size(); ++k)
        EXPECT_LE(near.swept[k - 1].begin, near.swept[k].begin);
}

}  // namespace
}  // namespace endmill
