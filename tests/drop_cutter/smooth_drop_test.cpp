// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/smooth_drop.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "dense_drop.h"
#include "offset_parts.h"

namespace endmill {
namespace {

const Cutter cutters[] = {Cutter::ball(4), Cutter{4, 1}, Cutter::flat(4)};

// The height of the highest contact, starting from a position far from it.
double height_over(const SmoothDrop& drop, const PartPlace& start,
                   const Eigen::Vector2d& axis)
{
    FinerPieces finer;
    const auto known = drop.climb(start, axis);
    return known ? drop.highest(*known, axis, finer).on.height : -1e300;
}

TEST(SmoothDrop, FindsTheHighestOfSeveralHills)
{
    // Two slopes of a trough that is too narrow for the cutter, and its border.
    const test::Polynomial trough = test::monomial(2, 0, 0.2) +
                                    test::monomial(0, 1, 0.3) +
                                    test::monomial(3, 0, 0.002);
    const test::Rectangle over{{-9, 10}, {-8, 9}};
    const std::vector<Surface> part{test::graph(trough, over, {2, 3})};
    const test::PlanPart plan = test::plan_graph(trough, over);
    test::Random random{3};
    for (const Cutter& cutter : cutters) {
        const SmoothDrop drop{part, cutter};
        for (int k = 0; k < 20; ++k) {
            const Eigen::Vector2d axis{random.uniform(-11, 12), random.uniform(-10, 11)};
            const double expected =
                test::DenseDrop(plan, cutter, axis.x(), axis.y()).height();
            for (const SurfacePoint& start : {SurfacePoint{0, 0}, {2, 3}, {1, 0.5}})
                EXPECT_NEAR(height_over(drop, {0, start}, axis), expected, 1e-6);
        }
    }
}

TEST(SmoothDrop, RestsOnCreasesOfOneSurfaceAndOfSeveral)
{
    // A ridge within a surface, and four facets, each a surface of its own, that meet in
    // a tip.
    const std::vector<Surface> ridge{test::valley(10, 20, -0.5)};
    const std::vector<Surface> pyramid = test::pyramid(10, 0.5);
    const test::PlanPart ridge_plan{{{-10, 10}, {0, 20}},
                                    [](double x, double) { return -0.5 * std::abs(x); },
                                    {{{{0, 0}, {0, 20}}}}};
    const test::PlanPart pyramid_plan{
        {{-10, 10}, {-10, 10}},
        [](double x, double y) { return -0.5 * (std::abs(x) + std::abs(y)); },
        {{{{0, -10}, {0, 10}}}, {{{-10, 0}, {10, 0}}}}};
    test::Random random{4};
    for (const Cutter& cutter : cutters)
        for (int k = 0; k < 10; ++k) {
            const Eigen::Vector2d axis{random.uniform(-3, 3), random.uniform(-3, 3)};
            EXPECT_NEAR(height_over(SmoothDrop{ridge, cutter}, {0, {0.9, 0.5}}, axis),
                        test::DenseDrop(ridge_plan, cutter, axis.x(), axis.y()).height(),
                        1e-5);
            EXPECT_NEAR(
                height_over(SmoothDrop{pyramid, cutter}, {0, {0.9, 0.9}}, axis),
                test::DenseDrop(pyramid_plan, cutter, axis.x(), axis.y()).height(), 1e-5);
        }
    const SmoothDrop drop{ridge, cutters[0]};
    EXPECT_FALSE(drop.climb({0, {0.9, 0.5}}, {0, 10})->is_inside);
    EXPECT_TRUE(drop.climb({0, {0.9, 0.5}}, {-4, 10})->is_inside);
}

TEST(SmoothDrop, CrossesSmoothJointsOfPatches)
{
    const test::Polynomial hill =
        test::monomial(2, 0, -0.02) + test::monomial(0, 2, -0.03);
    const test::Rectangle over{{-10, 10}, {-10, 10}};
    const std::vector<Surface> whole{test::graph(hill, over)};
    const std::vector<Surface> parts{test::graph(hill, over, {4, 5})};
    for (const Cutter& cutter : cutters)
        for (const Eigen::Vector2d& axis :
             {Eigen::Vector2d{-6, 7}, {0, 0}, {4.9, -2.1}}) {
            const auto one = SmoothDrop{whole, cutter}.climb({0, {0.4, 0.6}}, axis);
            const auto other = SmoothDrop{parts, cutter}.climb({0, {3.9, 0.1}}, axis);
            ASSERT_TRUE(one && other);
            EXPECT_NEAR(one->on.height, other->on.height, 1e-10);
            EXPECT_TRUE(other->is_inside);
        }
}

TEST(SmoothDrop, IsNoneBesideThePart)
{
    const std::vector<Surface> part{test::plane(20, 10)};
    EXPECT_FALSE(SmoothDrop(part, cutters[0]).climb({0, {0.5, 0.5}}, {25, 5}));
}

}  // namespace
}  // namespace endmill
