// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/csv.h"
#include "made_deviation.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr DeviationLimits limits{0.01, 0.09};  // bins of 0.001 mm

struct Bin {
    double from;
    double to;
    double area;
};

std::vector<Bin> bins_of(const Deviation& deviation)
{
    const CsvTable table = parse_csv(deviation_histogram_csv(deviation, limits), "h");
    std::vector<Bin> bins;
    for (std::size_t i = 0; i < table.rows(); ++i)
        bins.push_back({*table.number(i, "from_mm"), *table.number(i, "to_mm"),
                        *table.number(i, "area_mm2")});
    return bins;
}

// Cells in one tile of a unit square, which is all that a histogram needs.
Deviation of_values(const std::vector<float>& left, const std::vector<float>& area)
{
    Deviation deviation;
    PartTile tile{};
    tile.columns = static_cast<int>(left.size());
    tile.rows = 1;
    deviation.tiles = {tile};
    deviation.left = left;
    deviation.area = area;
    return deviation;
}

TEST(DeviationHistogram, HasBinsOfAHundredthOfBothLimits)
{
    const auto bins = bins_of(of_values({0.0105F, 0.0125F, 0.0108F}, {1, 2, 4}));
    ASSERT_EQ(bins.size(), 3U);
    EXPECT_EQ(bins[0].from, 0.0105F);
    EXPECT_NEAR(bins[0].to, 0.011, 1e-15);
    EXPECT_EQ(bins[0].area, 5);
    EXPECT_NEAR(bins[1].to - bins[1].from, 0.001, 1e-15);
    EXPECT_EQ(bins[1].area, 0);
    EXPECT_EQ(bins[2].to, 0.0125F);
    EXPECT_EQ(bins[2].area, 2);
}

TEST(DeviationHistogram, EndsReachBeyondTwiceTheLimits)
{
    const auto bins = bins_of(of_values({-3, 5, 0, 0.3F}, {1, 2, 4, 8}));
    ASSERT_EQ(bins.size(), 200U);
    EXPECT_EQ(bins.front().from, -3);
    EXPECT_NEAR(bins.front().to, -0.019, 1e-15);
    EXPECT_EQ(bins.front().area, 1);
    EXPECT_NEAR(bins.back().from, 0.179, 1e-15);
    EXPECT_EQ(bins.back().to, 5);
    EXPECT_EQ(bins.back().area, 10);
}

TEST(DeviationHistogram, CoversTheAreaOfAPartWithoutGaps)
{
    const Part part = std::vector<Surface>{test::plane(7, 5)};
    const Deviation deviation =
        made_deviation(part_charts(part), 0.05, [](const Vec3& point) {
            return 0.05 + 0.08 * std::sin(4 * point.x() + point.y());
        });
    const auto bins = bins_of(deviation);
    double sum = 0;
    for (std::size_t k = 0; k < bins.size(); ++k) {
        sum += bins[k].area;
        EXPECT_LT(bins[k].from, bins[k].to);
        if (k > 0) {
            EXPECT_EQ(bins[k].from, bins[k - 1].to);
        }
        double expected = 0;
        for (std::size_t i = 0; i < deviation.left.size(); ++i)
            if (deviation.left[i] >= bins[k].from &&
                (deviation.left[i] < bins[k].to || k + 1 == bins.size()))
                expected += deviation.area[i];
        EXPECT_NEAR(bins[k].area, expected, 1e-12);
    }
    EXPECT_NEAR(sum, deviation.area_mm2, 1e-9);
    EXPECT_NEAR(sum, 35, 1e-4);
}

TEST(DeviationHistogram, OfOneValueIsOneRowAndOfNoneTheHeader)
{
    const auto bins = bins_of(of_values({0.02F, 9}, {3, 0}));  // one cell without area
    ASSERT_EQ(bins.size(), 1U);
    EXPECT_EQ(bins[0].from, 0.02F);
    EXPECT_EQ(bins[0].to, 0.02F);
    EXPECT_EQ(bins[0].area, 3);
    EXPECT_EQ(deviation_histogram_csv({}, limits), "from_mm,to_mm,area_mm2\n");
}

TEST(DeviationHistogram, RefusesInvalidLimitsAndValues)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Deviation deviation = of_values({0}, {1});
    EXPECT_THROW(deviation_histogram_csv(deviation, {0, 0.1}), DomainError);
    EXPECT_THROW(deviation_histogram_csv(deviation, {0.01, infinite}), DomainError);
    EXPECT_THROW(
        deviation_histogram_csv(of_values({static_cast<float>(infinite)}, {1}), limits),
        DomainError);
}

}  // namespace
}  // namespace endmill
