// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of the removed volume and the remaining heights, on grids of decreasing
// pitch. Expected values without a source of their own are those of
// docs/methods/removal.md, section 4.

#include <cmath>
#include <numbers>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/stock/removal.h"
#include "tip_path.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::tip_path;

// Tips over a block of 40 by 24 mm with its top at 0 and its bottom at -20.
struct Case {
    const char* name;
    Cutter cutter;
    std::vector<Vec3> tips;
    double volume;  // mm^3
    double wall;    // mm^2, area of the cut's upright walls
};

std::ostream& operator<<(std::ostream& out, const Case& one)
{
    return out << one.name;
}

class RemovedVolume : public testing::TestWithParam<Case> {};

// A wall may lie anywhere in its cells, so half a cell along it is uncertain. Slanted
// surfaces are summed at the centres, which is more accurate by one order; the constant
// is that of a rim where the slope starts at once.
TEST_P(RemovedVolume, IsTheClosedFormWithinThePitch)
{
    const Case& one = GetParam();
    for (const double pitch : {0.4, 0.2, 0.1, 0.05}) {
        HeightStock stock = block_stock({{-20, -12, -20}, {20, 12, 0}}, pitch);
        const Removal removal = remove_along(stock, tip_path(one.tips), one.cutter);
        const double of_walls = 0.5 * pitch * one.wall;
        const double of_rims = pitch * pitch * 10;
        EXPECT_NEAR(removal.total, one.volume, of_walls + of_rims) << pitch;
    }
}

const Vec3 here{0.0123, 0.0217, 0};

std::vector<Vec3> through(double depth)
{
    return {{-40, here.y(), -depth}, {40, here.y(), -depth}};
}

std::vector<Vec3> inside(double depth)
{
    return {{-10, here.y(), -depth}, {10, here.y(), -depth}};
}

std::vector<Vec3> down(double depth)
{
    return {here + Vec3{0, 0, 30}, here - Vec3{0, 0, depth}};
}

// A move of 10 mm between two depths of the tip.
std::vector<Vec3> ramp(double from, double to)
{
    return {{-5, here.y(), -from}, {5, here.y(), -to}};
}

const Cutter ball = Cutter::ball(5);
const Cutter flat = Cutter::flat(5);
const Cutter bull{5, 2};

INSTANTIATE_TEST_SUITE_P(
    Straight, RemovedVolume,
    testing::Values(Case{"ball through", ball, through(1), 40 * 4.08752771983, 0},
                    Case{"ball deep", ball, through(7), 40 * (pi * 25 / 2 + 2 * 5 * 2),
                         2 * 40 * 2},
                    Case{"ball inside", ball, inside(1), 96.4113201134, 0},
                    Case{"bull through", bull, through(1), 40 * 8.45673939722, 0},
                    Case{"bull deep", bull, through(4), 40 * 38.2831853072, 2 * 40 * 2},
                    Case{"flat through", flat, through(3), 40 * 10 * 3, 2 * 40 * 3}));

INSTANTIATE_TEST_SUITE_P(
    Plunges, RemovedVolume,
    testing::Values(Case{"ball", ball, down(1), pi*(15 - 1) / 3, 0},
                    Case{"ball deep", ball, down(7), pi*(250.0 / 3 + 25 * 2),
                         2 * pi * 5 * 2},
                    Case{"flat", flat, down(2), pi * 25 * 2, 2 * pi * 5 * 2},
                    Case{"bull", bull, down(1), 56.6645449646, 0},
                    Case{"bull deep", bull, down(4), 289.601087670, 2 * pi * 5 * 2}));

// The ball's centre goes from 2 to 6 below the top; the tip is 5 deeper.
INSTANTIATE_TEST_SUITE_P(
    Ramps, RemovedVolume,
    testing::Values(Case{"ball", ball, ramp(7, 11), 1398.908508070, 200},
                    Case{"ball backwards", ball, ramp(11, 7), 1398.908508070, 200},
                    Case{"ball shallow", ball, ramp(0, 1), 24.8038806070, 0},
                    Case{"flat", flat, ramp(2, 6), 5 * 10 * 8 + pi * 25 * 6, 200},
                    Case{"flat backwards", flat, ramp(6, 2), 5 * 10 * 8 + pi * 25 * 6,
                         200}));

// Straight passes along x at the given y, with tips at `tip_z`.
ToolPath passes(const std::vector<double>& across, double tip_z)
{
    std::vector<Vec3> tips;
    for (const double y : across) {
        tips.emplace_back(-40, y, tip_z);
        tips.emplace_back(40, y, tip_z);
        // The link to the next pass stays clear of the block.
        tips.emplace_back(40, y, 90);
        tips.emplace_back(-40, y, 90);
        tips.emplace_back(-40, y + 1, 90);
    }
    return tip_path(tips);
}

// Height at y = 0 in the middle of the block, where a cell has its centre.
double height_at_zero(const HeightStock& stock)
{
    const int row = stock.grid().rows / 2;
    EXPECT_NEAR(stock.grid().y(row), 0, 1e-12);
    return stock.height(stock.grid().columns / 2, row);
}

HeightStock odd_block()
{
    return block_stock({{-10.05, -10.05, -20}, {10.05, 10.05, 20}}, 0.1);
}

TEST(ParallelPasses, LeaveTheScallopOfTheirPitch)
{
    const auto scallop = [](double pitch) {
        HeightStock stock = odd_block();
        remove_along(
            stock, passes({-1.5 * pitch, -pitch / 2, pitch / 2, 1.5 * pitch}, -1), ball);
        return height_at_zero(stock) + 1;
    };
    EXPECT_NEAR(scallop(2), 0.101020514434, 1e-12);
    EXPECT_NEAR(scallop(3), 0.230303992915, 1e-12);
    EXPECT_NEAR(scallop(1.98997487421), 0.1, 1e-11);
}

TEST(ParallelPasses, WithOneOmittedLeaveTheScallopOfTwiceThePitch)
{
    const double pitch = 1.5;
    HeightStock stock = odd_block();
    remove_along(stock, passes({-2 * pitch, -pitch, pitch, 2 * pitch}, -1), ball);
    EXPECT_NEAR(height_at_zero(stock) + 1, 5 - std::sqrt(25 - pitch * pitch), 1e-12);
}

TEST(ParallelPasses, LeaveTheMeanOfTheirPitch)
{
    const double pitch = 1.98997487421;
    // The passes are a whole number of cells apart, and the midpoint rule is of second
    // order.
    const double cell = pitch / 40;
    HeightStock stock = block_stock({{-5, -pitch / 2, -20}, {5, pitch / 2, 20}}, cell);
    remove_along(stock, passes({-pitch, 0, pitch}, -1), ball);
    double sum = 0;
    for (int row = 0; row < stock.grid().rows; ++row)
        sum += stock.height(3, row) + 1;
    ASSERT_EQ(stock.grid().rows, 40);
    EXPECT_NEAR(sum / 40, 0.0331988468909, cell * cell / 24 / 5 * 2);
}

TEST(ParallelPasses, TakeTheSectionOfTheirUnion)
{
    for (const double pitch : {0.2, 0.1, 0.05}) {
        HeightStock stock = block_stock({{-20, -12, -20}, {20, 12, 0}}, pitch);
        const Removal removal = remove_along(stock, passes({-4, -2, 0, 2, 4}, -1), ball);
        EXPECT_NEAR(removal.total, 40 * 11.8192377411, 40 * pitch * pitch);
    }
}

// Two passes at equal angles on both sides of the top of a cylinder about x, and of the
// bottom of a hollow cylinder.
// Source: docs/methods/removal.md, section 4.
TEST(ParallelPasses, OnACylinderLeaveItsScallop)
{
    const auto outside = [](double degrees) {
        const double half = degrees / 2 * pi / 180;
        HeightStock stock = block_stock({{-5, -4.05, 0}, {5, 4.05, 40}}, 0.1);
        const double z = 25 * std::cos(half) - 5;
        remove_along(stock, passes({-25 * std::sin(half), 25 * std::sin(half)}, z), ball);
        return height_at_zero(stock) - 20;
    };
    EXPECT_NEAR(outside(4), 0.0614825764327, 1e-12);
    const auto inside_one = [](double degrees) {
        const double half = degrees / 2 * pi / 180;
        HeightStock stock = block_stock({{-5, -4.05, -40}, {5, 4.05, 0}}, 0.1);
        const double z = -15 * std::cos(half) - 5;
        remove_along(stock, passes({-15 * std::sin(half), 15 * std::sin(half)}, z), ball);
        return height_at_zero(stock) + 20;
    };
    EXPECT_NEAR(inside_one(6), 0.0825702199982, 1e-12);
}

// A floor at -2 and a wall at y = 3: the wall stays whole, and everything before it is
// removed.
TEST(FlatCutter, LeavesFloorAndWall)
{
    for (const Cutter& cutter : {flat, bull}) {
        HeightStock stock = block_stock({{-20, -12, -20}, {20, 12, 0}}, 0.1);
        remove_along(stock, passes({-2, -6, -10}, -2), cutter);
        const double foot = 3 - cutter.corner_radius();
        for (int row = 0; row < stock.grid().rows; ++row) {
            const double y = stock.grid().y(row);
            if (y > 3) {
                EXPECT_EQ(stock.height(200, row), 0);
            } else if (y < foot) {
                EXPECT_EQ(stock.height(200, row), -2);
            }
        }
    }
}

// A level path, turned about z, removes the same volume except for the grid's error at
// the outline.
TEST(Removal, DependsLittleOnTheDirection)
{
    for (const double degrees : {0.0, 17.0, 45.0, 90.0}) {
        const double a = degrees * pi / 180;
        const Vec3 half{10 * std::cos(a), 10 * std::sin(a), 0};
        const Vec3 depth{0, 0, 1};
        HeightStock stock = block_stock({{-18, -18, -20}, {18, 18, 0}}, 0.1);
        const Removal removal = remove_along(
            stock, tip_path({here - half - depth, here + half - depth}), ball);
        EXPECT_NEAR(removal.total, 96.4113201134, 0.1);
    }
}

}  // namespace
}  // namespace endmill
