// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_engagement.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/stock/detail/stock_probe.h"
#include "endmill/stock/removal.h"
#include "tip_path.h"

namespace endmill {
namespace {

using std::numbers::pi;

// The eight means over the front, summed cell by cell from their definition.
// Source: docs/methods/ball-end-milling.md, section 2.
std::array<double, 8> coefficients(const BallFront& front)
{
    std::array<double, 8> sums{};
    const auto add = [&](double azimuth, double radius, double weight) {
        const double sine = std::sin(azimuth);
        const double cosine = std::cos(azimuth);
        const double chip = std::abs(sine);
        const std::array<double, 8> terms{
            chip * cosine, chip * sine, cosine, sine, chip, 1, chip * radius, radius};
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += weight * terms[k] / (2 * pi);
    };
    const double cell = 2.0 / front.rows * (pi / 2 - front.lambda) / front.columns;
    for (std::size_t i = 0; i < front.engaged.size(); ++i) {
        const double y =
            -1 + 2 * (static_cast<double>(i / front.columns) + 0.5) / front.rows;
        const double chi =
            (front.lambda - pi / 2) *
            (1 - (static_cast<double>(i % front.columns) + 0.5) / front.columns);
        const double x = std::sqrt(1 - y * y) * std::cos(chi);
        if (front.engaged[i] != 0)
            add(std::atan2(x, y), std::hypot(x, y), cell);
    }
    for (std::size_t k = 0; k < front.shank.size(); ++k)
        add(pi * (static_cast<double>(k) + 0.5) / front.columns, 1,
            pi / front.columns * front.shank[k]);
    return sums;
}

// Returns the last front of a one-way raster of a ball of radius 5 on a flat stock.
BallFront last_of_raster(double pick_feed, double depth, double pitch, bool to_right)
{
    HeightStock stock = block_stock({{-15, -30, -20}, {15, 30, depth}}, pitch);
    ToolPath path;
    for (int pass = 0; pass < 4; ++pass) {
        const double y = (to_right ? -1 : 1) * pick_feed * pass;
        for (const Vec3& tip : {Vec3{-30, y, 40}, Vec3{-30, y, 0}, Vec3{30, y, 0}})
            path.points.push_back({pass,
                                   0,
                                   tip.x() < 0 ? Move::Rapid : Move::Cut,
                                   0,
                                   {tip, Vec3::UnitZ()}});
    }
    // The last pass has two moves. The middle of the second one is over the stock.
    path.points.back().location.tip.x() = -1;
    path.points.push_back(path.points.back());
    path.points.back().location.tip.x() = 1;
    BallFront last;
    const std::array<std::size_t, 1> points{path.points.size() - 1};
    for_each_ball_front(stock, {&path, Cutter::ball(5), points},
                        [&](std::size_t number, const BallFront& front) {
                            EXPECT_EQ(number, 0u);
                            last = front;
                        });
    return last;
}

struct Printed {
    double pick_feed_ratio;
    double depth_ratio;
    std::array<double, 8> values;
};

// Source: docs/methods/ball-end-milling.md, section 9, A5, at mu = lambda = 0.
const std::array printed{
    Printed{0.5,
            1,
            {.06384156802699, .08122766740608, .1398948673934, .1150000083393,
             .1150000083393, .2072694459767, .07874058938143, .1488873959654}},
    Printed{0.5,
            .5,
            {.03310299987801, .05514060585237, .06995695731694, .07333334167258,
             .07333334167258, .1217977757768, .03895185360845, .0672035423783}},
    Printed{0.5,
            2,
            {.1235246716864, .1301029447756, .2777270912488, .1945774798852,
             .1945774798852, .3739361126434, .1583180609274, .3155540626321}},
    Printed{.2,
            1,
            {.03728384772234, .02566727760484, .1075518205349, .04840712028115,
             .04840712028115, .1249150463843, .03177785710762, .09018025953232}}};

// An upright wall may lie anywhere between two centres. The uncertainty is a pitch over
// the radius for both ends of the shank's engaged angle, times the height of the shank.
TEST(StockFronts, OfAFlatRasterTendToItsClosedForm)
{
    for (const Printed& row : printed)
        for (const auto& [pitch, tolerance] :
             {std::pair{0.5, 3e-3}, std::pair{0.1, 1.5e-3}}) {
            const BallFront front =
                last_of_raster(5 * row.pick_feed_ratio, 5 * row.depth_ratio, pitch, true);
            EXPECT_EQ(front.stock_side, FeedSide::Right);
            const auto found = coefficients(front);
            const double shank =
                std::max(row.depth_ratio - 1, 0.0) * pitch / 5 / (2 * pi);
            for (std::size_t k = 0; k < found.size(); ++k)
                EXPECT_NEAR(found[k], row.values[k], tolerance + shank)
                    << "I" << k + 1 << " R_p " << row.pick_feed_ratio << " R_l "
                    << row.depth_ratio << " pitch " << pitch;
        }
}

TEST(StockFronts, AreTheSameMilledUpOrDown)
{
    const BallFront down = last_of_raster(2.5, 7, 0.5, true);
    const BallFront up = last_of_raster(2.5, 7, 0.5, false);
    EXPECT_EQ(down.stock_side, FeedSide::Right);
    EXPECT_EQ(up.stock_side, FeedSide::Left);
    EXPECT_EQ(down.engaged, up.engaged);
    EXPECT_EQ(down.rim_angle, up.rim_angle);
}

// The angle is acos(1 - R_p) beside a pass as deep as the ball, and half a turn in a
// slot.
TEST(StockFronts, HaveTheAngleOfTheirRim)
{
    EXPECT_NEAR(last_of_raster(2.5, 6, 0.1, true).rim_angle, std::acos(0.5), 0.03);
    HeightStock stock = block_stock({{-15, -15, -20}, {15, 15, 3}}, 0.1);
    const ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {2, 0, 1}});
    std::array<double, 2> angles{};
    const std::array<std::size_t, 2> points{1, 2};
    for_each_ball_front(stock, {&path, Cutter::ball(5), points},
                        [&](std::size_t number, const BallFront& front) {
                            angles.at(number) = front.rim_angle;
                        });
    EXPECT_NEAR(angles.at(0), pi, 0.1);
    EXPECT_EQ(angles.at(1), 0);  // a move straight up
}

TEST(StockFronts, OfAnUphillSlotHaveItsClosedCoefficients)
{
    // Source: docs/methods/ball-end-milling.md, section 9, A7, in the middle of a
    // long slope; lambda = -0.3 is downhill.
    const double lambda = -0.3;
    HeightStock stock = block_stock({{-30, -12, -30}, {30, 12, 5}}, 0.1);
    const Vec3 way{std::cos(lambda), 0, std::sin(lambda)};
    const ToolPath path = test::tip_path({-20 * way, -0.1 * way, 0.1 * way});
    std::array<double, 8> found{};
    const std::array<std::size_t, 1> points{2};
    for_each_ball_front(
        stock, {&path, Cutter::ball(5), points},
        [&](std::size_t, const BallFront& front) { found = coefficients(front); });
    EXPECT_NEAR(found[0], 0, 1.5e-3);
    EXPECT_NEAR(found[5], 0.5 - lambda / pi, 4e-3);
    EXPECT_NEAR(found[6], (2 - std::cos(lambda)) / 4, 4e-3);
}

// Reference: each front is computed alone, on a stock that the path up to it has left.
// The moves are shorter than the ball and go back and forth, so that every move meets the
// cuts of the moves just before it.
TEST(StockFronts, EqualFrontsComputedOneByOne)
{
    const Block block{{-12, -12, -20}, {12, 12, 4}};
    std::vector<Vec3> tips;
    for (int k = 0; k < 150; ++k) {
        const int pass = k / 25;
        const double x = -13 + (pass % 2 == 0 ? k % 25 : 24 - k % 25);
        tips.emplace_back(x, -6 + 2.5 * pass, std::sin(0.9 * k));
    }
    const ToolPath path = test::tip_path(tips);
    std::vector<std::size_t> points;
    for (std::size_t k = 1; k < tips.size(); ++k)
        points.push_back(k);
    HeightStock whole = block_stock(block, 0.5);
    std::vector<BallFront> fronts(points.size());
    for_each_ball_front(
        whole, {&path, Cutter::ball(5), points},
        [&](std::size_t number, const BallFront& front) { fronts[number] = front; });
    for (const std::size_t k : {1, 2, 40, 65, 66, 129, 149}) {
        HeightStock stock = block_stock(block, 0.5);
        for (std::size_t i = 0; i + 1 < k; ++i)
            remove_swept(stock, Cutter::ball(5), swept_move(tips[i], tips[i + 1]));
        const ToolPath move = test::tip_path({tips[k - 1], tips[k]});
        const std::array<std::size_t, 1> last{1};
        for_each_ball_front(stock, {&move, Cutter::ball(5), last},
                            [&](std::size_t, const BallFront& front) {
                                EXPECT_EQ(front.engaged, fronts[k - 1].engaged) << k;
                                EXPECT_EQ(front.shank, fronts[k - 1].shank) << k;
                                EXPECT_EQ(front.rim_angle, fronts[k - 1].rim_angle) << k;
                            });
    }
    // The remaining stock is that of the removal.
    HeightStock removed = block_stock(block, 0.5);
    remove_along(removed, path, Cutter::ball(5));
    EXPECT_NEAR(stock_volume(whole), stock_volume(removed), 1e-9);
}

TEST(StockFronts, RefuseUnsupportedInput)
{
    HeightStock stock = block_stock({{-5, -5, -5}, {5, 5, 0}}, 0.5);
    const ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}});
    const auto visit = [](std::size_t, const BallFront&) {};
    const std::vector<std::size_t> one{1};
    EXPECT_THROW(for_each_ball_front(stock, {&path, Cutter::flat(5), one}, visit),
                 DomainError);
    EXPECT_THROW(for_each_ball_front(stock, {&path, Cutter::ball(5), one, 3, 4}, visit),
                 DomainError);
    const std::vector<std::size_t> beyond{2};
    const std::vector<std::size_t> twice{1, 1};
    EXPECT_THROW(for_each_ball_front(stock, {&path, Cutter::ball(5), beyond}, visit),
                 DomainError);
    EXPECT_THROW(for_each_ball_front(stock, {&path, Cutter::ball(5), twice}, visit),
                 DomainError);
}

}  // namespace
}  // namespace endmill
