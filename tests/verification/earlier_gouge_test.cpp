// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/earlier_gouge.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/cutter/straight_sweep.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A plane tilted about y, and a stock with the groove of a ball that passes level along y
// and cuts `depth` mm into the plane.
struct GroovedSlope {
    GroovedSlope(double slope, double depth, double pitch)
        : normal{-std::sin(slope), 0, std::cos(slope)},
          part{std::vector<Surface>{test::parallelogram(
              8 * Vec3{std::cos(slope), 0, std::sin(slope)}, {0, 6, 0})}},
          stock{block_stock({{-1, -1, -4}, {9, 7, 20}}, pitch)}
    {
        const Vec3 contact = 4 * Vec3{std::cos(slope), 0, std::sin(slope)};
        const Vec3 tip = contact + (3 - depth) * normal - Vec3{0, 0, 3};
        const StraightSweep groove{Cutter::ball(3), tip + Vec3{0, -9, 0},
                                   tip + Vec3{0, 19, 0}};
        const StockGrid& grid = stock.grid();
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                stock.set_height(column, row,
                                 std::min(stock.height(column, row),
                                          groove.height(grid.x(column), grid.y(row))));
    }

    EarlierGouge found(double resolution) const
    {
        const PartCharts charts = part_charts(part);
        return earlier_gouge(charts, part_tiles(charts, resolution, 10'000'000), stock);
    }

    Vec3 normal;
    Part part;
    HeightStock stock;
};

constexpr double degree = std::numbers::pi / 180;

TEST(EarlierGouge, BoundsTheDepthOfAGrooveOnASlope)
{
    for (const double slope : {0.0, 15.0, 30.0, 45.0, 60.0})
        for (const double pitch : {0.2, 0.1, 0.05}) {
            const double depth = 0.3;
            const EarlierGouge gouge =
                GroovedSlope{slope * degree, depth, pitch}.found(pitch);
            EXPECT_LE(gouge.found_mm, depth + 1e-9) << slope << " " << pitch;
            EXPECT_GE(gouge.found_mm + gouge.bound_mm, depth - 1e-9)
                << slope << " " << pitch;
            if (gouge.found_at) {
                EXPECT_LT(gouge.found_at->dot(Vec3{std::cos(slope * degree), 0,
                                                   std::sin(slope * degree)}) -
                              4,
                          std::sqrt(2 * 3 * depth));
            }
        }
}

// The bound falls with the pitch.
TEST(EarlierGouge, HasTighterBoundsForAFinerStock)
{
    double before = 1;
    for (const double pitch : {0.2, 0.1, 0.05}) {
        const double bound = GroovedSlope{30 * degree, 0.3, pitch}.found(pitch).bound_mm;
        EXPECT_LT(bound, before);
        before = bound;
    }
    EXPECT_LT(before, 0.2);
}

TEST(EarlierGouge, IsNoneUnderAnAllowance)
{
    const EarlierGouge gouge = GroovedSlope{45 * degree, -0.3, 0.05}.found(0.05);
    EXPECT_EQ(gouge.found_mm, 0);
    EXPECT_EQ(gouge.bound_mm, 0);
    EXPECT_FALSE(gouge.found_at);
}

}  // namespace
}  // namespace endmill
