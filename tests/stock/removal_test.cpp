// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/removal.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/cutter/straight_sweep.h"
#include "random.h"
#include "tip_path.h"

namespace endmill {
namespace {

using test::tip_path;

HeightStock small_block(double pitch)
{
    return block_stock({{-20, -15, -12}, {20, 15, 0}}, pitch);
}

// A path that goes up and down over the block, cuts, misses and leaves it.
ToolPath wild_path(int points, unsigned seed)
{
    test::Random random{seed};
    std::vector<Vec3> tips;
    for (int k = 0; k < points; ++k)
        tips.emplace_back(random.uniform(-25, 25), random.uniform(-20, 20),
                          random.uniform(-9, 4));
    return tip_path(tips);
}

std::vector<double> heights_of(const HeightStock& stock)
{
    std::vector<double> heights;
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column)
            heights.push_back(stock.height(column, row));
    return heights;
}

class RemovalOf : public testing::TestWithParam<Cutter> {};

TEST_P(RemovalOf, LeavesTheLeastOfAllSweeps)
{
    HeightStock stock = small_block(0.37);
    const ToolPath path = wild_path(25, 1);
    remove_along(stock, path, GetParam());
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column) {
            double expected = 0;
            for (std::size_t k = 1; k < path.points.size(); ++k)
                expected = std::min(
                    expected, StraightSweep{GetParam(), path.points[k - 1].location.tip,
                                            path.points[k].location.tip}
                                  .height(stock.grid().x(column), stock.grid().y(row)));
            EXPECT_NEAR(stock.height(column, row), expected, 1e-11);
        }
}

TEST_P(RemovalOf, VolumesOfTheMovesSumToTheRemovedVolume)
{
    HeightStock stock = small_block(0.25);
    const double before = stock_volume(stock);
    const Removal removal = remove_along(stock, wild_path(40, 2), GetParam());
    const double sum =
        std::accumulate(removal.removed.begin(), removal.removed.end(), 0.0);
    EXPECT_NEAR(removal.total, sum, 1e-12 * before);
    EXPECT_NEAR(removal.total, before - stock_volume(stock), 1e-12 * before);
}

TEST_P(RemovalOf, IsTheSameInAHundredPieces)
{
    // No cell has its centre on the rim, where rounding decides.
    const Vec3 from{-8.3123, -3.1417, -6};
    const Vec3 to{9.7071, 4.4349, -2};
    HeightStock whole = small_block(0.2);
    HeightStock pieces = whole;
    HeightStock backwards = whole;
    std::vector<Vec3> tips;
    for (int k = 0; k <= 100; ++k)
        tips.push_back(from + k / 100.0 * (to - from));
    const Removal one = remove_along(whole, tip_path({from, to}), GetParam());
    const Removal many = remove_along(pieces, tip_path(tips), GetParam());
    const Removal back = remove_along(backwards, tip_path({to, from}), GetParam());
    EXPECT_NEAR(many.total, one.total, 1e-12 * one.total);
    EXPECT_NEAR(back.total, one.total, 1e-12 * one.total);
    const std::vector<double> expected = heights_of(whole);
    const std::vector<double> in_pieces = heights_of(pieces);
    const std::vector<double> from_end = heights_of(backwards);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_NEAR(in_pieces[k], expected[k], 1e-11);
        EXPECT_NEAR(from_end[k], expected[k], 1e-11);
    }
}

TEST_P(RemovalOf, IsTheSameForEveryNumberOfThreads)
{
    const ToolPath path = wild_path(3000, 3);
    const RemovalOptions options{{{.diameter = 14, .from = 6, .to = 30}}};
    std::vector<double> heights;
    std::vector<Removal> removals;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        HeightStock stock = small_block(0.2);
        removals.push_back(remove_along(stock, path, GetParam(), options));
        if (heights.empty())
            heights = heights_of(stock);
        EXPECT_EQ(heights_of(stock), heights);
        EXPECT_EQ(removals.back().removed, removals.front().removed);
        EXPECT_EQ(removals.back().deepest, removals.front().deepest);
        EXPECT_EQ(removals.back().total, removals.front().total);
        EXPECT_EQ(removals.back().collisions.count, removals.front().collisions.count);
        EXPECT_EQ(removals.back().collisions.deepest,
                  removals.front().collisions.deepest);
    }
    EXPECT_GT(removals.front().collisions.count, 0U);
}

// Parts bound the memory. Cutting in parts or at once must follow the order of the path
// in the same way.
TEST_P(RemovalOf, IsTheSameInManyRuns)
{
    const ToolPath path = wild_path(9000, 4);
    HeightStock at_once = small_block(0.5);
    HeightStock in_runs = at_once;
    const Removal removal = remove_along(at_once, path, GetParam());
    std::vector<double> removed;
    for (std::size_t first = 0; first + 1 < path.points.size(); first += 1000) {
        const std::size_t last = std::min(path.points.size() - 1, first + 1000);
        ToolPath part;
        part.points.assign(path.points.begin() + static_cast<std::ptrdiff_t>(first),
                           path.points.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        part.points.front().move = Move::Link;
        const Removal run = remove_along(in_runs, part, GetParam());
        removed.insert(removed.end(), run.removed.begin() + 1, run.removed.end());
    }
    EXPECT_EQ(heights_of(in_runs), heights_of(at_once));
    ASSERT_EQ(removed.size() + 1, removal.removed.size());
    for (std::size_t k = 1; k < removed.size(); ++k)
        EXPECT_NEAR(removed[k], removal.removed[k + 1], 1e-9);
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, RemovalOf,
                         testing::Values(Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}));

TEST(Removal, TheFirstPointCutsIfTheCutterHasComeDownThere)
{
    for (const Move move : {Move::Cut, Move::Plunge}) {
        HeightStock stock = small_block(0.5);
        const Removal removal =
            remove_along(stock, tip_path({{0.1, 0.1, -3}}, move), Cutter::flat(4));
        EXPECT_NEAR(removal.total, 3.14159 * 16 * 3, 10);
        EXPECT_EQ(removal.removed.at(0), removal.total);
        EXPECT_EQ(removal.air_moves, 0U);
    }
    for (const Move move : {Move::Link, Move::Rapid, Move::Retract}) {
        HeightStock stock = small_block(0.5);
        const Removal removal =
            remove_along(stock, tip_path({{0.1, 0.1, -3}}, move), Cutter::flat(4));
        EXPECT_EQ(removal.total, 0);
        EXPECT_EQ(removal.rapid_cuts.count, 0U);
    }
}

TEST(Removal, OfAnEmptyPathIsNone)
{
    HeightStock stock = small_block(0.5);
    const Removal removal = remove_along(stock, {}, Cutter::ball(5));
    EXPECT_EQ(removal.total, 0);
    EXPECT_TRUE(removal.removed.empty());
    ASSERT_TRUE(removal.left);
    EXPECT_EQ(removal.left->low, 0);
}

TEST(Removal, CountsMovesInTheAir)
{
    HeightStock stock = small_block(0.5);
    const Removal removal = remove_along(
        stock,
        tip_path({{-30, 0, 5}, {30, 0, 5}, {30, 0, -1}, {-30, 0, -1}, {30, 0, -1}}),
        Cutter::ball(5));
    // The moves pass over the block, beside it, through it, and where nothing is left.
    EXPECT_EQ(removal.air_moves, 3U);
    EXPECT_EQ(removal.removed[2], 0);
    EXPECT_GT(removal.removed[3], 0);
    EXPECT_NEAR(removal.deepest[3], 1, 1e-2);
}

TEST(Removal, FindsRapidMovesThatCut)
{
    ToolPath path = tip_path(
        {{-30, 0, 3}, {30, 0, 3}, {30, 5, -1}, {-30, 5, -1}, {-30, 5, -2}, {30, 5, -2}});
    for (const std::size_t k : {1, 2, 3, 5})
        path.points[k].move = Move::Rapid;
    HeightStock stock = small_block(0.5);
    const Removal removal = remove_along(stock, path, Cutter::flat(5));
    EXPECT_EQ(removal.rapid_cuts.count, 2U);
    EXPECT_EQ(removal.rapid_cuts.first, 3U);
    EXPECT_EQ(removal.rapid_cuts.deepest, 1);
}

// A rapid in the groove that was just cut touches nothing.
TEST(Removal, RapidsInRemovedMaterialAreAllowed)
{
    ToolPath path = tip_path({{-30, 0.3, -2}, {30, 0.3, -2}, {-30, 0.3, -2}});
    path.points[2].move = Move::Rapid;
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}}) {
        HeightStock stock = small_block(0.5);
        EXPECT_EQ(remove_along(stock, path, cutter).rapid_cuts.count, 0U);
    }
}

// The path lies on a lattice of cells, so that many cells lie on the cutter's rim. A
// cutter that goes back or up through its own cut touches nothing, nor does a shank of
// the same width.
TEST_P(RemovalOf, MaterialAtTheRimIsNotTouchedOnRetracting)
{
    test::Random random{4};
    const auto place = [&](double z) {
        return Vec3{0.05 * std::round(random.uniform(-200, 200)),
                    0.05 * std::round(random.uniform(-150, 150)), z};
    };
    for (int run = 0; run < 40; ++run) {
        const Vec3 from = place(-3);
        const Vec3 over = place(-3);
        const Vec3 to = place(-3);
        ToolPath path =
            tip_path({from + Vec3{0, 0, 8}, from, over, to, over, over + Vec3{0, 0, 8}});
        path.points[0].move = path.points[4].move = path.points[5].move = Move::Rapid;
        HeightStock stock = small_block(0.1);
        const Removal removal = remove_along(
            stock, path, GetParam(), {{ToolCylinder{2 * GetParam().radius(), 8, 60}}});
        EXPECT_EQ(removal.rapid_cuts.count, 0U) << run;
        EXPECT_EQ(removal.collisions.count, 0U) << run;
    }
}

// One pass through a block at a feed: the rate is section times feed, and the mean is
// volume over time.
TEST(RemovalRates, AreVolumeByTime)
{
    HeightStock stock = small_block(0.5);
    ToolPath path = tip_path({{-10, 0, -2}, {10, 0, -2}, {10, 0, 5}, {-10, 0, 5}});
    path.points[1].conditions.feed_mm_per_min = 100;
    path.points[2].conditions.feed_mm_per_min = 1000;
    path.points[3].move = Move::Rapid;
    const Removal removal = remove_along(stock, path, Cutter::flat(5));
    EXPECT_NEAR(*removal_rate(removal, path, 1), 10 * 2 * 100, 1e-9);
    EXPECT_FALSE(removal_rate(removal, path, 3));
    const auto rates = removal_rates(removal, path);
    EXPECT_NEAR(rates->greatest, 2000, 1e-9);
    const double time_min = 20.0 / 100 + 7.0 / 1000;
    EXPECT_NEAR(rates->mean, (removal.removed[1] + removal.removed[2]) / time_min, 1e-9);
    for (PathPoint& point : path.points)
        point.conditions = {};
    EXPECT_FALSE(removal_rates(removal, path));
}

// The block is 12 thick. Where it is cut through, no height lies below the bottom.
TEST(Removal, GoesNoDeeperThanTheBottom)
{
    HeightStock stock = small_block(0.5);
    const Removal removal =
        remove_along(stock, tip_path({{-30, 0, -50}, {30, 0, -50}}), Cutter::flat(5));
    EXPECT_NEAR(removal.total, 40 * 10 * 12, 1e-9);
    EXPECT_EQ(removal.deepest[1], 12);
    ASSERT_TRUE(removal.left);
    EXPECT_EQ(removal.left->low, 0);
}

TEST(Removal, HasNoHeightRangeWithoutRemainingStock)
{
    HeightStock stock = block_stock({{-1, -1, -1}, {1, 1, 0}}, 0.1);
    const Removal removal = remove_along(stock, tip_path({{0, 0, -2}}), Cutter::flat(5));
    EXPECT_FALSE(removal.left);
    EXPECT_NEAR(removal.total, 4, 1e-12);
}

class BodyOverGroove : public testing::Test {
protected:
    // A flat cutter of radius 3 cuts a groove along x, `depth` deep. A cylinder begins 10
    // above its tip.
    static MoveCount collisions(double depth, double body_diameter)
    {
        HeightStock stock = small_block(0.5);
        const ToolPath path = tip_path(
            {{-30, 0.1, 5}, {-30, 0.1, -depth}, {30, 0.1, -depth}, {30, 0.1, 5}});
        return remove_along(stock, path, Cutter::flat(3),
                            {{{.diameter = body_diameter, .from = 10, .to = 40}}})
            .collisions;
    }
};

TEST_F(BodyOverGroove, CollidesIfItIsWiderAndDeeper)
{
    const MoveCount found = collisions(11, 8);
    EXPECT_EQ(found.count, 1U);
    EXPECT_EQ(found.first, 2U);
    EXPECT_NEAR(found.deepest, 1, 1e-12);
}

TEST_F(BodyOverGroove, IsClearIfItIsNoWider)
{
    EXPECT_EQ(collisions(11, 6).count, 0U);
    EXPECT_EQ(collisions(11, 4).count, 0U);
}

TEST_F(BodyOverGroove, IsClearIfItIsAbove)
{
    EXPECT_EQ(collisions(10, 8).count, 0U);
    EXPECT_EQ(collisions(5, 30).count, 0U);
}

// The cylinder meets the wall at the end of the groove before the cutter could remove it
// on the same move, whether the move is divided or not.
TEST(Collisions, AreFoundAheadOfTheCutter)
{
    const Vec3 from{-40, 0.1, -11};
    const Vec3 to{30, 0.1, -11};
    for (const int pieces : {1, 50}) {
        // The block is narrower than the cutter's radius.
        HeightStock stock = block_stock({{-20, -2, -12}, {20, 2, 0}}, 0.25);
        std::vector<Vec3> tips;
        for (int k = 0; k <= pieces; ++k)
            tips.push_back(from + k / double(pieces) * (to - from));
        const Removal removal = remove_along(stock, tip_path(tips), Cutter::flat(3),
                                             {{{.diameter = 8, .from = 10, .to = 40}}});
        EXPECT_GT(removal.collisions.count, 0U);
        EXPECT_NEAR(removal.collisions.deepest, 1, 1e-12);
    }
}

TEST(Removal, RefusesUnsupportedPaths)
{
    HeightStock stock = small_block(0.5);
    ToolPath path = tip_path({{0, 0, 0}, {1, 0, 0}});
    path.points[1].location.axis = Vec3{0.6, 0, 0.8};
    EXPECT_THROW(remove_along(stock, path, Cutter::ball(5)), GeometryError);
    EXPECT_THROW(remove_along(stock, tip_path({{0, 0, std::nan("")}}), Cutter::ball(5)),
                 DomainError);
    EXPECT_THROW(remove_along(stock, tip_path({{0, 1e10, 0}}), Cutter::ball(5)),
                 DomainError);
    EXPECT_THROW(remove_along(stock, tip_path({{0, 0, 0}}), Cutter::ball(5),
                              {{{.diameter = 0, .from = 1, .to = 2}}}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
