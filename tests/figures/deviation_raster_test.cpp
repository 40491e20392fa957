// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/deviation_raster.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "made_deviation.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr DeviationLimits limits{0.01, 0.1};

Part plane_part()
{
    return std::vector<Surface>{test::plane(20, 10)};
}

// 32 cells per mm in tiles of 8 by 8: 4 by 4 cells in each square of 1/8 mm.
TEST(DeviationRaster, ShowsTheWorstCellOfEachSquare)
{
    const Part part = plane_part();
    const PartCharts charts = part_charts(part);
    const Deviation deviation = made_deviation(
        charts, 1.0 / 16, [](const Vec3& p) { return 0.001 * p.x() + 0.0001 * p.y(); });
    const DeviationRaster raster = deviation_raster(charts, deviation, limits, 80);
    EXPECT_EQ(raster.columns, 80);
    EXPECT_EQ(raster.rows, 40);
    EXPECT_EQ(raster.side, 0.25);
    // A deviation that grows with x and y is largest in the last cell of a square, whose
    // centre is at most the side of a cell away from the far corner.
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column) {
            const double most = 0.001 * 0.25 * (column + 1) + 0.0001 * 0.25 * (row + 1);
            EXPECT_LE(raster.at(column, row), most);
            EXPECT_GE(raster.at(column, row), most - 0.0011 / 16);
        }
}

TEST(DeviationRaster, PrefersTheLargerShareOfItsLimitAndThenTheGouge)
{
    const Part part = plane_part();
    const PartCharts charts = part_charts(part);
    Deviation deviation = made_deviation(charts, 1, [](const Vec3&) { return 0.05; });
    const auto shown = [&] {
        return deviation_raster(charts, deviation, limits, 1).left;
    };
    EXPECT_EQ(shown(), std::vector{0.05F});
    deviation.left[9] = -0.004F;
    EXPECT_EQ(shown(), std::vector{0.05F});
    deviation.left[9] = -0.006F;
    EXPECT_EQ(shown(), std::vector{-0.006F});
    deviation.left[2] = 0.09F;
    EXPECT_EQ(shown(), std::vector{0.09F});
    EXPECT_EQ(share_of_limit(-0.02, limits), 2);
    EXPECT_EQ(share_of_limit(0.05, limits), 0.5);
}

TEST(DeviationRaster, HasNoHolesWhereCellsAreLarge)
{
    const Part part = plane_part();
    const PartCharts charts = part_charts(part);
    const Deviation deviation =
        made_deviation(charts, 4, [](const Vec3& p) { return 0.001 * p.x(); });
    const DeviationRaster raster = deviation_raster(charts, deviation, limits, 100);
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column)
            EXPECT_NEAR(raster.at(column, row), 0.001 * 0.2 * (column + 0.5), 0.00221);
}

TEST(DeviationRaster, IsEmptyWhereThePartDoesNotShow)
{
    const Part part = std::vector<Surface>{test::parallelogram({10, 0, 5}, {10, 20, 0})};
    const PartCharts charts = part_charts(part);
    const Deviation deviation =
        made_deviation(charts, 0.1, [](const Vec3&) { return 0.01; });
    const DeviationRaster raster = deviation_raster(charts, deviation, limits, 40);
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column) {
            const double x = 0.5 * (column + 0.5);
            const double y = 0.5 * (row + 0.5);
            const double inside = std::min(x - y / 2, 10 + y / 2 - x);
            if (std::abs(inside) > 0.5) {
                EXPECT_EQ(raster.at(column, row),
                          inside > 0 ? 0.01F : DeviationRaster::nothing);
            }
        }
}

TEST(DeviationRaster, OfAWallIsALineAndOfAnEmptyPartASquare)
{
    const Part wall = std::vector<Surface>{test::parallelogram({10, 0, 0}, {0, 0, 5})};
    const PartCharts charts = part_charts(wall);
    const Deviation deviation =
        made_deviation(charts, 0.5, [](const Vec3&) { return -0.1; });
    const DeviationRaster raster = deviation_raster(charts, deviation, limits, 20);
    EXPECT_EQ(raster.columns, 20);
    EXPECT_EQ(raster.rows, 1);
    EXPECT_EQ(raster.left, std::vector<float>(20, -0.1F));

    const Part none = std::vector<Surface>{};
    EXPECT_EQ(deviation_raster(part_charts(none), {}, limits, 20).left,
              std::vector{DeviationRaster::nothing});
}

TEST(DeviationRaster, IsTheSameForAnyNumberOfThreads)
{
    const Part part = plane_part();
    const PartCharts charts = part_charts(part);
    const Deviation deviation = made_deviation(charts, 0.05, [](const Vec3& p) {
        return 0.1 * std::sin(31 * p.x()) * std::cos(17 * p.y());
    });
    const DeviationRaster raster = deviation_raster(charts, deviation, limits, 200);
    set_thread_count(1);
    EXPECT_EQ(deviation_raster(charts, deviation, limits, 200).left, raster.left);
    set_thread_count(2);
}

TEST(DeviationRaster, RefusesNoSquaresAndNoLimits)
{
    const Part part = plane_part();
    const PartCharts charts = part_charts(part);
    EXPECT_THROW(deviation_raster(charts, {}, limits, 0), DomainError);
    EXPECT_THROW(deviation_raster(charts, {}, {0, 0.1}, 10), DomainError);
    EXPECT_THROW(deviation_raster(charts, {}, {0.01, -1}, 10), DomainError);
}

}  // namespace
}  // namespace endmill
