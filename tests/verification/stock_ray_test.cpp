// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/stock_ray.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

const Block block{{-10, -10, -5}, {10, 10, 5}};

PartRay ray_of(const Vec3& point, const Vec3& direction)
{
    return {point, direction.normalized(), Vec3::Zero(), Vec3::Zero()};
}

TEST(RayInBlock, EndsAtTheFaceThatItLeavesThrough)
{
    EXPECT_EQ(ray_in_block(block, ray_of({0, 0, 1}, {0, 0, 1})).thickness, 4);
    const CutRay oblique = ray_in_block(block, ray_of({0, 0, 0}, {1, 0, 1}));
    EXPECT_NEAR(oblique.thickness, 5 * std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(oblique.slope, 1, 1e-15);
}

TEST(RayInBlock, LacksTheLengthBetweenItsPointAndTheBlock)
{
    EXPECT_EQ(ray_in_block(block, ray_of({0, 0, 6}, {0, 0, 1})).thickness, -1);
    EXPECT_EQ(ray_in_block(block, ray_of({11, 0, 0}, {1, 0, 0})).thickness, -1);
    const CutRay oblique = ray_in_block(block, ray_of({0, 0, 7}, {1, 0, 1}));
    EXPECT_NEAR(oblique.thickness, -2 * std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(oblique.slope, 1, 1e-14);
}

TEST(RayInBlock, LacksAllMaterialBesideTheBlock)
{
    EXPECT_EQ(ray_in_block(block, ray_of({11, 0, 0}, {0, 0, 1})).thickness, -5);
    const double level = ray_in_block(block, ray_of({-11, 0, 0}, {1, 0, 0})).thickness;
    EXPECT_NEAR(level, -std::sqrt(900.0), 1e-12);  // the diagonal
}

TEST(RayInStock, OfAFullBlockEqualsTheRayInTheBlock)
{
    const HeightStock stock = block_stock(block, 0.5);
    test::Random random{3};
    for (int i = 0; i < 500; ++i) {
        const PartRay ray =
            ray_of({random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-4, 4)},
                   {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1)});
        EXPECT_NEAR(ray_in_stock(stock, ray).thickness,
                    ray_in_block(block, ray).thickness, 1e-12);
    }
}

TEST(RayInStock, EndsAtAWallOfTheStock)
{
    HeightStock stock = block_stock(block, 0.5);
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 30; column < stock.grid().columns; ++column)
            stock.set_height(column, row, -5);
    // Columns from number 30 on begin at x = 5.
    EXPECT_NEAR(ray_in_stock(stock, ray_of({1, 0, 0}, {1, 0, 0})).thickness, 4, 1e-12);
    // The way back to the wall. The cell beside the wall has no certain height.
    EXPECT_NEAR(ray_in_stock(stock, ray_of({7, 0, 0}, {1, 0, 0})).thickness, -1.5, 1e-12);
    EXPECT_NEAR(ray_in_stock(stock, ray_of({70, 0, 0}, {1, 0, 0})).thickness, -60, 1e-12);
    EXPECT_NEAR(ray_in_stock(stock, ray_of({7, 0, 0}, {0, 0, 1})).thickness, -5, 1e-12);
}

// An earlier run has lowered the floor.
TEST(RayInStock, LacksTheMaterialRemovedBefore)
{
    HeightStock stock = block_stock(block, 0.5);
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column)
            stock.set_height(column, row, -0.5);
    EXPECT_NEAR(ray_in_stock(stock, ray_of({1.1, 2.2, 0}, {0, 0, 1})).thickness, -0.5,
                1e-12);
    EXPECT_NEAR(ray_in_stock(stock, ray_of({1.1, 2.2, 0}, {1, 0, 1})).thickness,
                -0.5 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(ray_in_stock(stock, ray_of({1.1, 2.2, -2}, {0, 0, 1})).thickness, 1.5,
                1e-12);
}

// The cells form steps. A slope that was cut exactly must not count as gouged.
TEST(RayInStock, DoesNotReportAStepAsAGouge)
{
    HeightStock stock = block_stock(block, 0.5);
    const StockGrid& grid = stock.grid();
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            stock.set_height(column, row,
                             0.4 * (grid.low_x + (column + 0.5) * grid.pitch));
    for (int i = 0; i < 50; ++i) {
        const double x = -5 + 0.171 * i;
        EXPECT_GE(ray_in_stock(stock, ray_of({x, 0.3, 0.4 * x}, {-0.4, 0, 1})).thickness,
                  0);
        const double deep =
            ray_in_stock(stock, ray_of({x, 0.3, 0.4 * x + 2}, {-0.4, 0, 1})).thickness;
        EXPECT_LE(deep, -1.4);
        EXPECT_GE(deep, -2 / std::hypot(1, 0.4));
    }
}

// A stock whose heights lie on a plane, `above` mm over the parallel plane through the
// origin.
HeightStock stock_on_plane(const Vec3& normal, double above, double pitch)
{
    HeightStock stock = block_stock(block, pitch);
    const StockGrid& grid = stock.grid();
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            stock.set_height(
                column, row,
                (above - normal.x() * grid.x(column) - normal.y() * grid.y(row)) /
                    normal.z());
    return stock;
}

PartRay ray_on_plane(const Vec3& normal, test::Random& random)
{
    const double x = random.uniform(-2, 2);
    const double y = random.uniform(-2, 2);
    return ray_of({x, y, -(normal.x() * x + normal.y() * y) / normal.z()}, normal);
}

const Vec3 slopes[] = {{0, 0, 1}, {0.5, 0, 1}, {-1, 0.7, 1}};

// The whole slope lies 0.3 below the part, along the normal. The highest cell around ends
// 1.5 pitches away along x and y, and the ray comes nearer to it by as much.
TEST(RayInStock, ShowsAGougeOnASlopeLessDeepByNoMoreThanTheCellsAround)
{
    const double pitch = 0.1;
    for (const Vec3& along : slopes) {
        const Vec3 normal = along.normalized();
        const HeightStock stock = stock_on_plane(normal, -0.3, pitch);
        test::Random random{5};
        for (int i = 0; i < 200; ++i) {
            const double shown =
                -ray_in_stock(stock, ray_on_plane(normal, random)).thickness;
            EXPECT_LE(shown, 0.3 + 1e-12);
            const double slope = normal.head<2>().norm();
            EXPECT_GE(shown, 0.3 - slope * 1.5 * std::sqrt(2.0) * pitch - 1e-12);
        }
    }
}

// The bound is at least the plane's depth. It exceeds the depth by no more than the cells
// around, and the places within reach, are lower along the normal.
TEST(MostMissing, BoundsAGougeOnASlope)
{
    const double pitch = 0.1;
    const double reach = 0.06;
    for (const Vec3& along : slopes) {
        const Vec3 normal = along.normalized();
        const HeightStock stock = stock_on_plane(normal, -0.3, pitch);
        test::Random random{6};
        const double lower =
            normal.head<2>().norm() * (2.5 * std::sqrt(2.0) * pitch + reach);
        for (int i = 0; i < 200; ++i) {
            const double most = most_missing(stock, ray_on_plane(normal, random), reach);
            EXPECT_GE(most, 0.3 - 1e-12);
            EXPECT_LE(most, 0.3 + lower + 1e-9);
        }
    }
}

TEST(MostMissing, IsNoneUnderAnAllowance)
{
    const double pitch = 0.1;
    for (const Vec3& along : slopes) {
        const Vec3 normal = along.normalized();
        const double lower =
            normal.head<2>().norm() * (2.5 * std::sqrt(2.0) * pitch + 0.06);
        const HeightStock stock = stock_on_plane(normal, lower + 1e-9, pitch);
        test::Random random{7};
        for (int i = 0; i < 200; ++i)
            EXPECT_EQ(most_missing(stock, ray_on_plane(normal, random), 0.06), 0);
    }
}

// A single cell is missing, near rays that pass beside it.
TEST(MostMissing, FindsAHoleWithinReach)
{
    HeightStock stock = block_stock(block, 0.5);
    stock.set_height(20, 20, -3);
    const double x = stock.grid().x(20);
    // Between the cell's centre and the next the surface may dip as a ball with a radius
    // of one pitch does.
    EXPECT_EQ(most_missing(stock, ray_of({x, 0.25, 0}, {0, 0, 1}), 0.1), 3 + 0.5 * 0.293);
    EXPECT_EQ(most_missing(stock, ray_of({x + 0.9, 0.25, 0}, {0, 0, 1}), 0.5),
              3 + 0.5 * 0.293);
    EXPECT_EQ(most_missing(stock, ray_of({x + 3, 0.25, 0}, {0, 0, 1}), 0.1), 0);
    EXPECT_EQ(most_missing(stock, ray_of({70, 0, 0}, {0, 0, 1}), 0.1), 5);
}

}  // namespace
}  // namespace endmill
