// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/point_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

std::vector<NumberedPoint> random_points(int count, float width)
{
    test::Random random{3};
    std::vector<NumberedPoint> points;
    points.reserve(count);
    for (int k = 0; k < count; ++k)
        points.push_back(
            {{static_cast<float>(random.uniform(-1, 1)) * width,
              static_cast<float>(random.uniform(-1, 1)), static_cast<float>(k)},
             k});
    return points;
}

TEST(PointCells, ContainEachPointOnceInItsCell)
{
    for (const float width : {1.0F, 1e-3F, 0.0F}) {
        const std::vector<NumberedPoint> points = random_points(1003, width);
        PointCells cells;
        cells.sort(points);
        EXPECT_EQ(cells.points(), 1003U);
        std::vector<int> seen(points.size(), 0);
        for (int row = 0; row < cells.rows(); ++row)
            for (int column = cells.column_at(-2); column <= cells.column_at(2);
                 ++column) {
                const auto [begin, end] = cells.range(row, column, column);
                for (std::uint32_t place = begin; place < end; ++place) {
                    const PointBlock& block = cells.blocks()[place / 8];
                    const NumberedPoint& point = points[cells.number_at(place)];
                    ++seen[point.number];
                    EXPECT_EQ(block.x[place % 8], point.place.x());
                    EXPECT_EQ(block.y[place % 8], point.place.y());
                    EXPECT_EQ(block.z[place % 8], point.place.z());
                    EXPECT_EQ(cells.column_at(point.place.x()), column);
                    EXPECT_EQ(cells.row_at(point.place.y()), row);
                }
            }
        EXPECT_EQ(std::ranges::count(seen, 1), 1003);
        EXPECT_EQ(cells.blocks().back().number[7], -1);
    }
}

TEST(PointCells, AreAboutAsManyAsPoints)
{
    PointCells cells;
    cells.sort(random_points(10000, 3));
    const double count = cells.rows() * (cells.column_at(9) + 1.0);
    EXPECT_GT(count, 0.5 * 10000);
    EXPECT_LT(count, 2 * 10000);
    cells.sort(random_points(1, 3));
    EXPECT_EQ(cells.rows(), 1);
    cells.sort({});
    EXPECT_EQ(cells.points(), 0U);
}

TEST(PointCells, AreTheNearestForPlacesOutside)
{
    PointCells cells;
    cells.sort(random_points(10000, 3));
    EXPECT_EQ(cells.column_at(-100.0F), 0);
    EXPECT_EQ(cells.column_at(1e30F), cells.columns() - 1);
    EXPECT_EQ(cells.row_at(-1e30F), 0);
    EXPECT_EQ(cells.row_at(100.0F), cells.rows() - 1);
    EXPECT_NEAR(cells.row_at(0.0F), cells.rows() / 2.0, 1);
}

TEST(PointCells, KnowTheLowestPointOfEachCell)
{
    const std::vector<NumberedPoint> points = random_points(1003, 1);
    PointCells cells;
    cells.sort(points);
    for (int row = 0; row < cells.rows(); ++row)
        for (int first = 0; first + 2 < cells.columns(); first += 3) {
            const auto [begin, end] = cells.range(row, first, first + 2);
            float lowest = std::numeric_limits<float>::infinity();
            for (std::uint32_t place = begin; place < end; ++place)
                lowest = std::min(lowest, cells.point_at(place).place.z());
            EXPECT_EQ(cells.any_below(row, first, first + 2, 500), lowest <= 500);
        }
}

TEST(PointCells, AreAsManyAsAskedForIfThereAreFewPoints)
{
    PointCells cells;
    cells.sort(random_points(9, 1), 1000);
    EXPECT_GT(cells.rows() * cells.columns(), 500);
    EXPECT_LT(cells.rows() * cells.columns(), 2000);
    EXPECT_EQ(cells.points(), 9U);
}

TEST(PointCells, HaveNoNumberInPlacesWithoutAPoint)
{
    PointCells cells;
    for (const int count : {16, 11}) {
        cells.sort(random_points(count, 3));
        ASSERT_EQ(cells.blocks().size(), 2U);
        for (int lane = 0; lane < PointBlock::size; ++lane) {
            const bool is_there = 8 + lane < count;
            EXPECT_EQ(cells.blocks()[1].number[lane] >= 0, is_there);
            EXPECT_EQ(std::isfinite(cells.blocks()[1].x[lane]), is_there);
        }
    }
}

}  // namespace
}  // namespace endmill
