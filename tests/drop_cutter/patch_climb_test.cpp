// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/patch_climb.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dense_drop.h"

namespace endmill {
namespace {

const Cutter cutters[] = {Cutter::ball(4), Cutter{4, 1}, Cutter::flat(4)};

// z = 0.3 x - 0.2 y over [-10, 10]^2.
const test::Polynomial slope = test::monomial(1, 0, 0.3) + test::monomial(0, 1, -0.2);
const test::Rectangle square{{-10, 10}, {-10, 10}};

std::optional<PatchContact> climb_from(const Surface& surface,
                                       const Eigen::Vector2d& start, const Cutter& cutter,
                                       const Eigen::Vector2d& axis)
{
    const auto below = place_below(surface, start, cutter, axis);
    return below ? climb(surface, {0, 0}, *below, cutter, axis) : std::nullopt;
}

TEST(PatchClimb, RestsOnAPlaneByItsNormal)
{
    const Surface plane = test::graph(slope, square);
    // The offset of the plane: r along the normal and R - r horizontally, eq. (3).
    const Vec3 normal = Vec3{-0.3, 0.2, 1}.normalized();
    const double level = std::hypot(0.3, 0.2);
    for (const Cutter& cutter : cutters) {
        const Eigen::Vector2d axis{1, 2};
        const double expected = 0.3 * 1 - 0.2 * 2 + cutter.corner_radius() / normal.z() +
                                cutter.flat_radius() * level;
        for (const Eigen::Vector2d& start :
             {Eigen::Vector2d{0.5, 0.5}, {0.1, 0.9}, {0, 0}, {1, 1}}) {
            const auto contact = climb_from(plane, start, cutter, axis);
            ASSERT_TRUE(contact);
            EXPECT_NEAR(contact->height, expected, 4e-10);  // 1e-10 R
            EXPECT_NEAR(contact->slope.x(), 0.3, 1e-5);
            EXPECT_NEAR(contact->slope.y(), -0.2, 1e-5);
            EXPECT_LT(contact->beyond.norm(), 1e-5);
        }
    }
}

TEST(PatchClimb, RestsOnAnEdgeAndInACorner)
{
    const Surface plane = test::graph(slope, square);
    for (const Cutter& cutter : cutters) {
        // 3 mm beyond the edge x = 10: the section of the cutter there, on a sloped line.
        const auto edge = climb_from(plane, {0.5, 0.5}, cutter, {13, 0});
        ASSERT_TRUE(edge);
        const test::PlanPart part = test::plan_graph(slope, square);
        EXPECT_NEAR(edge->height, test::DenseDrop(part, cutter, 13, 0).height(), 1e-9);
        EXPECT_EQ(edge->at.x(), 1);
        EXPECT_GT(edge->beyond.x(), 0);
        const auto corner = climb_from(plane, {0.5, 0.5}, cutter, {11, -12});
        ASSERT_TRUE(corner);
        EXPECT_NEAR(corner->height,
                    5 + cutter.corner_radius() - cutter.profile(std::hypot(1, 2)), 1e-12);
        EXPECT_GT(corner->beyond.x(), 0);
        EXPECT_LT(corner->beyond.y(), 0);
    }
}

TEST(PatchClimb, FindsTheTopThatDenseSamplesFind)
{
    const test::Polynomial hills =
        test::monomial(2, 0, -0.03) + test::monomial(0, 2, -0.02) +
        test::monomial(1, 1, 0.013) + test::monomial(1, 0, 0.2);
    const test::PlanPart part = test::plan_graph(hills, square);
    const Surface surface = test::graph(hills, square);
    test::Random random{5};
    for (int k = 0; k < 30; ++k)
        for (const Cutter& cutter : cutters) {
            const Eigen::Vector2d axis{random.uniform(-12, 12), random.uniform(-12, 12)};
            const auto contact = climb_from(surface, {0.5, 0.5}, cutter, axis);
            ASSERT_TRUE(contact);
            EXPECT_NEAR(contact->height,
                        test::DenseDrop(part, cutter, axis.x(), axis.y()).height(), 1e-8);
        }
}

TEST(PatchClimb, GivesTheDerivativesOfTheHeight)
{
    const test::Polynomial hills = test::monomial(2, 0, -0.03) +
                                   test::monomial(0, 2, -0.02) +
                                   test::monomial(1, 0, 0.2);
    const Surface surface = test::graph(hills, square);
    constexpr double h = 1e-5;
    for (const Cutter& cutter : cutters)
        for (const Eigen::Vector2d& axis :
             {Eigen::Vector2d{-5, 3}, {-12, 4}, {-11, 11.5}, {12, -3}}) {
            const auto at = [&](double x, double y) {
                return climb_from(surface, {0.5, 0.5}, cutter,
                                  axis + Eigen::Vector2d{x, y})
                    ->height;
            };
            const auto contact = climb_from(surface, {0.5, 0.5}, cutter, axis);
            EXPECT_NEAR(contact->slope.x(), (at(h, 0) - at(-h, 0)) / (2 * h), 2e-5);
            EXPECT_NEAR(contact->slope.y(), (at(0, h) - at(0, -h)) / (2 * h), 2e-5);
        }
}

TEST(PatchClimb, IsNoneBesideThePatch)
{
    const Surface plane = test::graph(slope, square);
    for (const Cutter& cutter : cutters) {
        EXPECT_FALSE(climb_from(plane, {0.5, 0.5}, cutter, {14.1, 0}));
        EXPECT_FALSE(climb_from(plane, {0.9, 0.9}, cutter, {13, 13}));
        EXPECT_TRUE(climb_from(plane, {0.5, 0.5}, cutter, {13.9, 0}));
    }
}

TEST(PatchClimb, StandsStillOnALevelPlace)
{
    const Surface level = test::plane(20, 10);
    for (const Cutter& cutter : cutters) {
        const auto contact = climb_from(level, {0.5, 0.5}, cutter, {10, 5});
        ASSERT_TRUE(contact);
        EXPECT_EQ(contact->height, cutter.corner_radius());
        EXPECT_EQ(contact->slope, Eigen::Vector2d::Zero());
    }
}

TEST(PatchClimb, ComesToRestWhereAnEdgeCollapses)
{
    // The patch of a cone; its side u = 0 is one point.
    std::vector<Vec3> net;
    for (const double v : {0.0, 1.0, 2.0, 3.0})
        for (const double u : {0.0, 1.0, 2.0, 3.0})
            net.emplace_back(u * (3 - v), u * v, -0.5 * u);
    const Surface cone{{0, 1}, {0, 1}, {BezierPatch{net}}};
    for (const Cutter& cutter : cutters) {
        const auto contact = climb_from(cone, {0.5, 0.5}, cutter, {-1, -1});
        ASSERT_TRUE(contact);
        EXPECT_NEAR(contact->height,
                    cutter.corner_radius() - cutter.profile(std::hypot(1, 1)), 1e-9);
    }
}

}  // namespace
}  // namespace endmill
