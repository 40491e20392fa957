// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/distance_trimming.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

// Segments with slopes 1 and -1 cross in the origin, so that g_B - g_A = 2.
const std::vector<SectionPoint> loop{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}};
constexpr Branches of_loop{0, 1, 3, 4};

std::optional<ChainCrossing> search(double step, double threshold,
                                    FoldDetection detection = FoldDetection::Guarded)
{
    const SectionChain chain{loop, 0};
    return search_by_distance(
        chain, of_loop,
        {.detection = detection, .scan_step = step, .scan_threshold = threshold});
}

TEST(SearchByDistance, IsWithinItsBounds)
{
    for (const double step : {0.3, 0.07, 0.013, 1e-3}) {
        for (const double ratio : {1.01, 2.0, 7.0}) {
            const double threshold = ratio * step;  // step |g_B - g_A| <= 2 threshold
            const auto crossing = search(step, threshold);
            ASSERT_TRUE(crossing);
            EXPECT_FALSE(crossing->lies_on_both);
            EXPECT_LE(std::abs(crossing->at.y()), threshold / 2);
            EXPECT_LE(std::abs(crossing->at.x()), 1e-15);
        }
    }
}

// The first scan line is at the lower one of the highest points of both branches: z = 2,
// at s = -2.
TEST(SearchByDistance, MissesACrossingBetweenTwoLines)
{
    EXPECT_TRUE(search(0.4, 0.1)) << "z = 2 - 5 * 0.4 is the crossing itself";
    EXPECT_FALSE(search(0.3, 0.1)) << "no line within threshold / 2 of 0";
}

// A begins right of B's cusp and stays at least 0.1 right of B.
TEST(SearchByDistance, AcceptsNearBranchesWithoutACrossing)
{
    const std::vector<SectionPoint> beside{{0.3, 1}, {0.5, 0}, {0, -1}, {0.2, 1}, {6, 8}};
    const SectionChain chain{beside, 0};
    const TrimmingOptions options{
        .detection = FoldDetection::Literal, .scan_step = 0.01, .scan_threshold = 0.2};
    const auto crossing = search_by_distance(chain, {0, 1, 2, 4}, options);
    ASSERT_TRUE(crossing);
    EXPECT_FALSE(
        crossing_of(chain, crossing->segment_a, crossing->segment_b, CrossingType::Any));
}

TEST(TrimByDistance, NeverStepsBack)
{
    // The threshold is as large as the loop, so that the crossing lies behind vertices of
    // both branches.
    const SectionCurve curve = test::open_curve({{-6, 6},
                                                 {-1, 1.4},
                                                 {-0.5, 0.7},
                                                 {1, 0.1},
                                                 {2, -2},
                                                 {-2, -2},
                                                 {-1, 0.1},
                                                 {0.5, 0.7},
                                                 {1, 1.4},
                                                 {6, 6}});
    for (const double threshold : {0.01, 0.5, 1.5, 3.0}) {
        const auto points = test::points_left(
            test::trim("1", curve, {.scan_step = 0.01, .scan_threshold = threshold}));
        for (std::size_t i = 1; i < points.size(); ++i)
            EXPECT_GE(points[i].x(), points[i - 1].x());
    }
}

TEST(TrimByDistance, RefusesInvalidScanOptions)
{
    const SectionCurve curve = test::open_curve(loop);
    for (const TrimmingOptions& options :
         {TrimmingOptions{}, TrimmingOptions{.scan_step = 1},
          TrimmingOptions{.scan_step = -1, .scan_threshold = 1},
          TrimmingOptions{.scan_step = INFINITY, .scan_threshold = 1},
          TrimmingOptions{.scan_step = 1, .scan_threshold = NAN}})
        EXPECT_THROW(test::trim("1", curve, options), DomainError);
}

TEST(TrimByDistance, DoesNotScanForever)
{
    const SectionCurve curve = test::open_curve(loop);
    EXPECT_THROW(test::trim("1", curve, {.scan_step = 1e-300, .scan_threshold = 1e-300}),
                 LimitError);
}

}  // namespace
}  // namespace endmill
