// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_cells.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "made_deviation.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

double none_left(const Vec3& /*point*/)
{
    return 0;
}

TEST(DeviationCells, AreFoundByTheirNumber)
{
    const Part part = std::vector<Surface>{test::plane(3, 2, {2, 1})};
    const PartCharts charts = part_charts(part);
    const Deviation deviation = made_deviation(charts, 0.1, none_left);
    std::size_t number = 0;
    for (const PartTile& tile : deviation.tiles)
        for (int k = 0; k < tile.cells(); ++k, ++number) {
            const DeviationCell found = deviation_cell(charts, deviation, number);
            EXPECT_EQ(found.cell.chart, tile.whole.chart);
            EXPECT_EQ(found.cell.centre(), tile.cell(k).centre());
            // The parameter rises by 1 over each of the two patches.
            EXPECT_NEAR(found.ray.point.x(), 3 * found.cell.centre().x() / 2, 1e-14);
        }
    EXPECT_EQ(number, deviation.left.size());
}

TEST(DeviationCells, NeedTheChartsThatWereMeasured)
{
    const Part two = std::vector<Surface>{test::plane(1, 1, {2, 1})};
    const Part one = std::vector<Surface>{test::plane(1, 1)};
    const Deviation deviation = made_deviation(part_charts(two), 0.5, none_left);
    EXPECT_THROW(deviation_cell(part_charts(one), deviation, deviation.left.size() - 1),
                 DomainError);
}

TEST(DeviationCells, RequireACompleteAndFiniteDeviation)
{
    const Part part = std::vector<Surface>{test::plane(1, 1)};
    const Deviation whole = made_deviation(part_charts(part), 0.5, none_left);
    EXPECT_NO_THROW(require_whole(whole));
    EXPECT_NO_THROW(require_whole({}));
    Deviation short_by_one = whole;
    short_by_one.area.pop_back();
    EXPECT_THROW(require_whole(short_by_one), DomainError);
    for (const float bad : {std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
        Deviation broken = whole;
        broken.left[1] = bad;
        EXPECT_THROW(require_whole(broken), DomainError);
    }
}

}  // namespace
}  // namespace endmill
