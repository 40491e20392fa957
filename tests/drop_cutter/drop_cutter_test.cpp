// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/drop_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/detail/triangle_drop.h"
#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double none = -std::numeric_limits<double>::infinity();
const std::array cutters{Cutter::ball(1.5), Cutter::flat(1.5), Cutter{1.5, 0.4}};

// Random triangles of all sizes, on top of each other, upright, and some without area.
TriangleMesh rubble(test::Random& random, int count, double size)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < count; ++k) {
        const Vec3 centre = test::random_point(random, 8);
        const double wide = random.log_uniform(0.01 * size, size);
        for (int corner = 0; corner < 3; ++corner)
            points.emplace_back(centre + test::random_point(random, wide));
        if (k % 5 == 1)
            points.back() = points[points.size() - 2] + Vec3{0, 0, 1};
        if (k % 7 == 2)
            points.back() = points[points.size() - 2];
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        if (k % 11 == 3)
            triangles.push_back({3 * k, 3 * k + 2, 3 * k + 1});
    }
    return {std::move(points), std::move(triangles)};
}

std::vector<Vec2> places_over(test::Random& random, int count)
{
    std::vector<Vec2> places;
    for (int k = 0; k < count; ++k)
        places.emplace_back(random.uniform(-12, 12), random.uniform(-12, 12));
    return places;
}

// Second route: all triangles, one after the other.
DropContact highest(const TriangleMesh& mesh, const Cutter& cutter, const Vec2& place)
{
    DropContact best{none, {}, 0};
    const TriangleDrop drop{cutter};
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const TriangleContact found = drop(mesh.corners(k), place.x(), place.y());
        if (found.tip_z > best.tip_z)
            best = {found.tip_z, found.point, k};
    }
    return best;
}

TEST(DropCutter, FindsTheHighestOfAllTriangles)
{
    test::Random random{1};
    for (const double size : {0.3, 3.0, 30.0}) {
        const TriangleMesh mesh = rubble(random, 300, size);
        for (const Cutter& cutter : cutters) {
            const DropCutter drop_cutter{mesh, cutter};
            for (const Vec2& place : places_over(random, 100)) {
                const DropContact expected = highest(mesh, cutter, place);
                const auto found = drop_cutter.contact(place);
                ASSERT_EQ(found.has_value(), expected.tip_z > none);
                if (found) {
                    EXPECT_EQ(found->tip_z, expected.tip_z);
                    EXPECT_EQ(found->triangle, expected.triangle);
                    EXPECT_EQ(found->point, expected.point);
                }
            }
        }
    }
}

TEST(DropCutter, NeverGougesAndTouches)
{
    test::Random random{2};
    const TriangleMesh mesh = rubble(random, 200, 3);
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        for (const Vec2& place : places_over(random, 100)) {
            const auto found = drop_cutter.contact(place);
            const auto height_of_cutter = [&](const Vec3& q) {
                return cutter.profile((q.head<2>() - place).norm());
            };
            if (found) {  // rounding may put its point beyond the rim
                const double distance =
                    std::min((found->point.head<2>() - place).norm(), cutter.radius());
                EXPECT_NEAR(found->point.z() - cutter.profile(distance), found->tip_z,
                            1e-6);
            }
            for (int k = 0; k < 2000; ++k) {
                const auto [a, b, c] =
                    mesh.corners(static_cast<std::size_t>(random.uniform(0, 200)));
                const double u = random.uniform(0, 1);
                const double v = random.uniform(0, 1 - u);
                const Vec3 q = a + u * (b - a) + v * (c - a);
                EXPECT_LE(q.z() - height_of_cutter(q),
                          (found ? found->tip_z : none) + 1e-9);
            }
        }
    }
}

// A cylinder of radius 6 along y, divided into n facets. The ball rests R above it, minus
// the chord error, which falls as 1 / n^2.
TEST(DropCutter, RestsOnACylinder)
{
    const double radius = 6;
    for (const int strips : {100, 400}) {
        const TriangleMesh mesh = test::grid_mesh(strips, 1, [&](double i, double j) {
            const double angle = std::numbers::pi * i / strips;
            return Vec3{-radius * std::cos(angle), 20 * j - 10, radius * std::sin(angle)};
        });
        const DropCutter drop_cutter{mesh, Cutter::ball(2)};
        const double chord_error = radius * (1 - std::cos(std::numbers::pi / strips / 2));
        for (const double x : {0.0, 1.0, 4.0, 7.0}) {
            const double above = std::sqrt(8 * 8 - x * x) - 2;
            const double tip = drop_cutter.contact({x, 0})->tip_z;
            EXPECT_LE(tip, above + 1e-9);
            EXPECT_GE(tip, above - 4 * chord_error);
        }
    }
}

// A body that contains another never rests lower: ball, bull-nose, flat.
TEST(DropCutter, RestsHigherForFullerCutters)
{
    test::Random random{3};
    const TriangleMesh mesh = rubble(random, 200, 3);
    const DropCutter ball{mesh, Cutter::ball(1.5)};
    const DropCutter nearly_ball{mesh, {1.5, 1.5 - 1e-9}};
    const DropCutter bull{mesh, {1.5, 0.4}};
    const DropCutter flat{mesh, Cutter::flat(1.5)};
    for (const Vec2& place : places_over(random, 300)) {
        const auto lowest = ball.contact(place);
        if (!lowest)
            continue;
        EXPECT_LE(lowest->tip_z, bull.contact(place)->tip_z + 1e-9);
        EXPECT_LE(bull.contact(place)->tip_z, flat.contact(place)->tip_z + 1e-9);
        EXPECT_NEAR(lowest->tip_z, nearly_ball.contact(place)->tip_z, 1e-6);
    }
}

TEST(DropCutter, DoesNotDependOnHintsOrderOrThreads)
{
    test::Random random{4};
    const TriangleMesh mesh = rubble(random, 300, 1);
    const std::vector<Vec2> places = places_over(random, 2000);
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        set_thread_count(1);
        const auto alone = drop_cutter.contacts(places);
        const auto heights = drop_cutter.tip_heights(places);
        set_thread_count(4);
        const auto together = drop_cutter.contacts(places);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const auto one = drop_cutter.contact(places[k], k % 300);
            ASSERT_EQ(one.has_value(), alone[k].has_value());
            ASSERT_EQ(one.has_value(), together[k].has_value());
            EXPECT_EQ(heights[k], one ? one->tip_z : none);
            if (one) {
                EXPECT_EQ(one->tip_z, alone[k]->tip_z);
                EXPECT_EQ(one->triangle, alone[k]->triangle);
                EXPECT_EQ(one->point, together[k]->point);
                EXPECT_EQ(one->triangle, together[k]->triangle);
            }
        }
    }
}

// A fan of long thin triangles, which fill their boxes in plan badly.
TEST(DropCutter, WorksWithLongThinTriangles)
{
    std::vector<Vec3> points{{0, 0, 5}};
    std::vector<Triangle> triangles;
    constexpr int count = 1000;
    for (int k = 0; k <= count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        points.emplace_back(80 * std::cos(angle), 80 * std::sin(angle), -5);
        if (k > 0)
            triangles.push_back({0, k, k + 1});
    }
    const TriangleMesh mesh{points, triangles};
    test::Random random{5};
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        for (int k = 0; k < 50; ++k) {
            const Vec2 place{random.uniform(-85, 85), random.uniform(-85, 85)};
            const auto found = drop_cutter.contact(place);
            EXPECT_EQ(found ? found->tip_z : none, highest(mesh, cutter, place).tip_z);
        }
    }
}

// A small part far from the origin, which floats cannot resolve.
TEST(DropCutter, WorksFarFromTheOrigin)
{
    test::Random random{6};
    const TriangleMesh near = rubble(random, 200, 1);
    const Vec3 far{8192, -4096, 2048};
    std::vector<Vec3> points = test::points_of(near);
    for (Vec3& point : points)
        point += far;
    const TriangleMesh mesh{points, test::triangles_of(near)};
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        for (Vec2& place : places_over(random, 100)) {
            place += far.head<2>();
            const auto found = drop_cutter.contact(place);
            EXPECT_EQ(found ? found->tip_z : none, highest(mesh, cutter, place).tip_z);
        }
    }
}

TEST(DropCutter, FindsNothingBesideTheMesh)
{
    const TriangleMesh empty;
    const DropCutter over_nothing{empty, Cutter::ball(1)};
    EXPECT_FALSE(over_nothing.contact({0, 0}));
    EXPECT_TRUE(over_nothing.is_clear({0, 0, 0}, {1, 0, 0}, 0.1));
    const TriangleMesh square = test::flat_mesh(2, 2);  // x and y from 0 to 2
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{square, cutter};
        EXPECT_TRUE(drop_cutter.contact({3.5, 1}));
        EXPECT_FALSE(drop_cutter.contact({3.5 + 1e-15 * 4, 1}));
        EXPECT_FALSE(drop_cutter.contact({1e300, 1}));
    }
}

TEST(DropCutter, RefusesInvalidArguments)
{
    const TriangleMesh mesh = test::flat_mesh(2, 2);
    const DropCutter drop_cutter{mesh, Cutter::ball(1)};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(drop_cutter.contact({nan, 0}), DomainError);
    EXPECT_THROW(drop_cutter.contact({0, 0}, 8), DomainError);
    const std::vector<Vec2> places{{0, nan}};
    EXPECT_THROW(drop_cutter.tip_heights(places), DomainError);
    EXPECT_THROW(drop_cutter.is_clear({0, 0, 0}, {1, 0, 0}, 0), DomainError);
    EXPECT_THROW(drop_cutter.is_clear({0, 0, 0}, {nan, 0, 0}, 1), DomainError);
    EXPECT_THROW(drop_cutter.is_clear({0, 0, 0}, {90, 0, 0}, 1), DomainError);
    EXPECT_THROW(DropCutter(mesh, Cutter::ball(1e-7)), DomainError);
    const TriangleMesh far{{{1e10, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}};
    EXPECT_THROW(DropCutter(far, Cutter::ball(1)), DomainError);
}

// The largest rise of the mesh into the cutter at many positions of a move.
double sampled_rise(const DropCutter& drop_cutter, const Vec3& from, const Vec3& to)
{
    double rise = none;
    for (int k = 0; k <= 200; ++k) {
        const Vec3 tip = from + k / 200.0 * (to - from);
        if (const auto found = drop_cutter.contact(tip.head<2>()))
            rise = std::max(rise, found->tip_z - tip.z());
    }
    return rise;
}

TEST(DropCutter, CallsOnlyClearMovesClear)
{
    test::Random random{7};
    const TriangleMesh mesh = rubble(random, 300, 2);
    int clear = 0;
    int refused = 0;
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        for (const Vec2& place : places_over(random, 200)) {
            const double length = random.log_uniform(0.01, 3);
            const Vec3 from{place.x() / 2, place.y() / 2, random.uniform(-2, 9)};
            const Vec3 to = from + test::random_point(random, length);
            const double rise = sampled_rise(drop_cutter, from, to);
            if (drop_cutter.is_clear(from, to, 0.1)) {
                EXPECT_LE(rise, 0.1 + 1e-9);
                ++clear;
            } else {
                refused += rise < 0.09;
            }
        }
    }
    EXPECT_GT(clear, 100);
    EXPECT_LT(refused, 30);
}

}  // namespace
}  // namespace endmill
