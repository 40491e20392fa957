// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/cutter_core.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const std::array cutters{Cutter::ball(3), Cutter::flat(3), Cutter{3, 1}};

// Distance of a point from the outline of the cutter, by many points of the outline: the
// second route for the size of the gap.
double distance_from_outline(const Cutter& cutter, double across, double up)
{
    const double r = cutter.corner_radius();
    double least = 1e9;
    const auto look_at = [&](double x, double z) {
        least = std::min(least, std::hypot(across - x, up - z));
    };
    constexpr int count = 4000;
    for (int k = 0; k <= count; ++k) {
        const double share = double(k) / count;
        const double angle = share * std::acos(-1.0) / 2;
        look_at(share * cutter.flat_radius(), -r);
        look_at(cutter.flat_radius() + r * std::sin(angle), -r * std::cos(angle));
        look_at(cutter.radius(), 20 * share);
    }
    return least;
}

TEST(CutterCore, MeasuresTheGapToTheOutline)
{
    test::Random random{1};
    for (const Cutter& cutter : {cutters[1], cutters[2]}) {
        const Vec3 reference{1, -2, 4};
        const CutterCore core{cutter, reference};
        for (int k = 0; k < 300; ++k) {
            const Vec3 from = test::random_point(random, 5);
            const double across = from.head<2>().norm();
            const bool is_inside =
                across < 3 && from.z() + cutter.corner_radius() > cutter.profile(across);
            const double distance = distance_from_outline(cutter, across, from.z());
            EXPECT_NEAR(core.gap(reference + from), is_inside ? -distance : distance,
                        5e-3);
        }
    }
}

TEST(CutterCore, OfABallIsItsCentre)
{
    const CutterCore core{cutters[0], {1, 2, 3}};
    EXPECT_DOUBLE_EQ(core.gap({1, 2, 7}), 1);
    EXPECT_DOUBLE_EQ(core.gap({1, 6, 6}), 2);
    EXPECT_EQ(core.gap({1, 2, 3}), -3);
}

// The core lies behind each of its supporting planes, and no plane is farther from a
// point than the core.
TEST(CutterCore, LiesBehindItsSupportingPlanes)
{
    test::Random random{2};
    for (const Cutter& cutter : cutters) {
        const CutterCore core{cutter, Vec3::Zero()};
        for (int k = 0; k < 300; ++k) {
            const Vec3 p = test::random_point(random, 6);
            const Vec3 q = test::random_point(random, 6);
            for (const auto& [normal, distance] :
                 {core.nearest_plane(p), core.nearest_plane_below(p)}) {
                EXPECT_NEAR(normal.norm(), 1, 1e-15);
                EXPECT_LE(distance + normal.dot(q - p),
                          core.gap(q) + core.corner_radius() + 1e-12);
            }
            EXPECT_LE(core.nearest_plane_below(p).normal.z(), 0);
            EXPECT_LE(core.nearest_plane_below(p).distance,
                      core.nearest_plane(p).distance + 1e-12);
        }
    }
}

TEST(TriangleGap, IsTheLeastOverItsPoints)
{
    test::Random random{3};
    for (const Cutter& cutter : cutters)
        for (int k = 0; k < 60; ++k) {
            const CutterCore core{cutter, Vec3::Zero()};
            const std::array corners{test::random_point(random, 5),
                                     test::random_point(random, 5),
                                     test::random_point(random, 5)};
            const TriangleGap least = triangle_gap(core, corners, 1e-9, 1e9);
            EXPECT_NEAR(core.gap(least.point), least.gap, 1e-12);
            double sampled = 1e9;
            constexpr int count = 200;
            for (int i = 0; i <= count; ++i)
                for (int j = 0; j <= count - i; ++j) {
                    const Vec3 q = corners[0] + i * (corners[1] - corners[0]) / count +
                                   j * (corners[2] - corners[0]) / count;
                    sampled = std::min(sampled, core.gap(q));
                }
            EXPECT_LE(least.gap, sampled + 1e-9);
            EXPECT_GE(least.gap, sampled - 10.0 * 2 / count);
        }
}

TEST(TriangleGap, EndsForATriangleWithoutArea)
{
    const CutterCore core{cutters[1], Vec3::Zero()};
    const Vec3 p{0, 0, -2};
    EXPECT_EQ(triangle_gap(core, {p, p, p}, 1e-9, 1e9).gap, 2);
    EXPECT_NEAR(triangle_gap(core, {Vec3{-9, 0, -2}, p, Vec3{9, 0, -2}}, 1e-9, 1e9).gap,
                2, 1e-9);
}

}  // namespace
}  // namespace endmill
