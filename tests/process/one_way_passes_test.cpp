// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/one_way_passes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "reference_path.h"

namespace endmill {
namespace {

OneWayPasses passes_on_a_plane()
{
    return {.surface = [](double, double) { return HeightJet{}; },
            .extent = {{0, 25}, {0, 10}},
            .stock_top = 2};
}

// tests/process/reference_path.h computes the same path from the formula of the surface, without
// any code of the library.
TEST(OneWayPasses, OnTheTestSurfaceAreTheReferencePath)
{
    const OneWayPasses plan{.surface = ball_end_test_surface,
                            .extent = {{-60, 60}, {-40, 40}}};
    const std::vector<SegmentCut> cuts = milled_path(plan).cuts;
    const std::vector<SegmentCut> expected = test::reference_cuts();
    ASSERT_EQ(cuts.size(), expected.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        EXPECT_NEAR(cuts[i].length_mm, expected[i].length_mm, 1e-9);
        EXPECT_NEAR(cuts[i].lambda, expected[i].lambda, 1e-9);
        EXPECT_NEAR(cuts[i].depth_mm, expected[i].depth_mm, 1e-9);
        ASSERT_EQ(cuts[i].pick_feed_mm.has_value(), expected[i].pick_feed_mm.has_value());
        if (cuts[i].pick_feed_mm) {
            EXPECT_NEAR(*cuts[i].mu, *expected[i].mu, 1e-9);
            EXPECT_NEAR(*cuts[i].pick_feed_mm, *expected[i].pick_feed_mm, 1e-9);
        }
    }
}

TEST(OneWayPasses, OnAPlaneLieThePaperIntervalApart)
{
    const std::vector<double> places = pass_places(passes_on_a_plane());
    const double interval = std::sqrt(8 * 0.2 * 5);
    ASSERT_EQ(places.size(), 5U);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(places[k], static_cast<double>(k) * interval, 1e-12);
    EXPECT_EQ(places.back(), 10);
}

TEST(OneWayPasses, OnAPlaneCutInMovesOfTenMillimetres)
{
    const MilledPath milled = milled_path(passes_on_a_plane());
    ASSERT_EQ(milled.cuts.size(), 15U) << "5 passes of 10, 10 and 5 mm";
    EXPECT_NEAR(length_mm(milled.cuts), 5 * 25, 1e-12);
    EXPECT_EQ(milled.from.front(), Vec3(0, 10, 5));
    EXPECT_EQ(milled.to.front(), Vec3(10, 10, 5));
    for (const SegmentCut& cut : milled.cuts) {
        EXPECT_EQ(cut.depth_mm, 2);
        EXPECT_EQ(cut.lambda, 0);
    }
    EXPECT_NEAR(length_mm(stretched(milled.cuts, 250)), 250, 1e-10);
    EXPECT_NEAR(stretched(milled.cuts, 250).front().length_mm, 20, 1e-12);
}

TEST(OneWayPasses, ReturnAboveThePart)
{
    const OneWayPasses plan = passes_on_a_plane();
    const MilledPath milled = milled_path(plan);
    const double return_z = 7;
    const ToolPath path = milled_tool_path(milled, plan.radius, return_z);
    ASSERT_EQ(path.points.size(), 5U * (2 + 3 + 1));
    EXPECT_EQ(path.points[0].move, Move::Rapid);
    EXPECT_EQ(path.points[0].location.tip, Vec3(0, 10, 7));
    EXPECT_EQ(path.points[1].location.tip, Vec3(0, 10, 0));
    EXPECT_EQ(path.points[5].move, Move::Retract);
    EXPECT_EQ(path.points[5].location.tip, Vec3(25, 10, 7));

    // 5 plunges and 5 retracts of 7 mm, 4 returns between neighbouring passes, the return to the
    // start, and 1 mm of overrun for each pass.
    const double interval = std::sqrt(8 * 0.2 * 5);
    const double returns =
        3 * std::hypot(25, interval) + std::hypot(25, 10 - 3 * interval);
    EXPECT_NEAR(noncut_travel_mm(milled, plan.radius, return_z, 1),
                10 * 7 + returns + std::hypot(25, 10) + 5, 1e-9);
}

}  // namespace
}  // namespace endmill
