// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/stock_ray.h"

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
    EXPECT_EQ(ray_in_block(block, ray_of({0, 0, 1}, {0, 0, 1})).left, 4);
    const MownRay oblique = ray_in_block(block, ray_of({0, 0, 0}, {1, 0, 1}));
    EXPECT_NEAR(oblique.left, 5 * std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(oblique.slope, 1, 1e-15);
}

TEST(RayInBlock, HasNothingIfItBeginsOutside)
{
    EXPECT_EQ(ray_in_block(block, ray_of({0, 0, 6}, {0, 0, 1})).left, 0);
    EXPECT_EQ(ray_in_block(block, ray_of({11, 0, 0}, {1, 0, 0})).left, 0);
}

TEST(RayInStock, OfAFullBlockIsThatInTheBlock)
{
    const HeightStock stock = block_stock(block, 0.5);
    test::Random random{3};
    for (int i = 0; i < 500; ++i) {
        const PartRay ray =
            ray_of({random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-4, 4)},
                   {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1)});
        EXPECT_NEAR(ray_in_stock(stock, ray).left, ray_in_block(block, ray).left, 1e-12);
    }
}

TEST(RayInStock, EndsAtAWallOfTheStock)
{
    HeightStock stock = block_stock(block, 0.5);
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 30; column < stock.grid().columns; ++column)
            stock.set_height(column, row, -5);
    // Columns 30 and on begin at x = 5.
    EXPECT_NEAR(ray_in_stock(stock, ray_of({1, 0, 0}, {1, 0, 0})).left, 4, 1e-12);
    EXPECT_EQ(ray_in_stock(stock, ray_of({7, 0, 0}, {1, 0, 0})).left, 0);
    EXPECT_EQ(ray_in_stock(stock, ray_of({70, 0, 0}, {1, 0, 0})).left, 0);
}

}  // namespace
}  // namespace endmill
