// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/border_depth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/gouge/gouge_test.h"
#include "normal_depth.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;

bool is_kept(const Surface& part, const BallMove& move, double depth,
             const Vec3& axis = Vec3::UnitZ())
{
    const double side = tool_side_sign(part, axis);
    return BorderDepth{{&part, 1}, {&side, 1}, BallCutter{radius}, axis, depth}.is_kept(
        move);
}

double depth_in_ball(const Surface& part, const BallMove& move)
{
    const auto deepest =
        GougeTest{{&part, 1}, BallCutter{radius}, Vec3::UnitZ()}.deepest(move, 1e-6);
    return deepest ? deepest->depth_mm : 0;
}

// A ball beside the edge x = 0 of a plane, with its centre a beyond the edge and h above
// the plane. Along the normal at the edge it cuts to the depth sqrt(R^2 - a^2) - h.
TEST(BorderDepth, IsTheClosedFormBesideAnEdge)
{
    const Surface part = test::plane(40, 30);
    for (const double a : {0.5, 2.0, 4.0})
        for (const double taken : {0.02, 0.5}) {
            const double h = std::sqrt(radius * radius - a * a) - taken;
            const BallMove stay{{-a, 15, h}, {-a, 15, h}};
            const BallMove along{{-a, 5, h}, {-a, 25, h}};
            const BallMove plunge{{-a, 15, h + 30}, {-a, 15, h}};
            const BallMove ramp{{-a, 5, h + 3}, {-a, 25, h}};
            for (const BallMove& move : {stay, along, plunge, ramp}) {
                EXPECT_LT(depth_in_ball(part, move), taken);
                EXPECT_TRUE(is_kept(part, move, 1.003 * taken)) << a << ' ' << taken;
                EXPECT_FALSE(is_kept(part, move, 0.997 * taken)) << a << ' ' << taken;
            }
        }
}

// BorderDepth does not judge cuts inside the plane; GougeTest does.
TEST(BorderDepth, JudgesTheBorderOnly)
{
    const Surface part = test::plane(40, 30);
    EXPECT_TRUE(is_kept(part, {{20, 15, 1}, {20, 14, 1}}, 0.1));
    EXPECT_TRUE(is_kept(part, {{-9, 15, 1}, {-9, 14, -7}}, 0.1));
    // The ball touches the edge from the side; the rest of it is below.
    EXPECT_TRUE(is_kept(part, {{-radius, 15, 0}, {-radius, 15, 0}}, 0.1));
}

// Two surfaces have a border between them unless they meet.
TEST(BorderDepth, IgnoresSidesWhereSurfacesMeet)
{
    const std::vector<Surface> apart{test::plane(40, 30)};
    const std::vector<Surface> joined{test::plane(40, 30),
                                      test::parallelogram({-40, 0, 0}, {0, 30, 0})};
    const std::vector<double> sides{tool_side_sign(joined[0], Vec3::UnitZ()),
                                    tool_side_sign(joined[1], Vec3::UnitZ())};
    const BallMove move{{-2, 15, 4.3}, {-2, 15, 4.3}};
    const auto kept = [&](const std::vector<Surface>& part) {
        return BorderDepth{part, std::span{sides}.first(part.size()), BallCutter{radius},
                           Vec3::UnitZ(), 0.2}
            .is_kept(move);
    };
    EXPECT_FALSE(kept(apart));
    EXPECT_TRUE(kept(joined));
}

// Random moves over a curved patch, compared with rays along its normals, on the border
// and beside it, and with balls at many positions of each move.
TEST(BorderDepth, AgreesWithRaysOverACurvedPatch)
{
    const Surface part = test::saddle(30, 15, {2, 2});
    const Vec3 axis = Vec3::UnitZ();
    const double side = tool_side_sign(part, axis);
    constexpr double depth = 0.2;
    const BorderDepth border{{&part, 1}, {&side, 1}, BallCutter{radius}, axis, depth};
    const GougeTest gouge{{&part, 1}, BallCutter{radius}, axis};
    test::Random random{7};
    const Interval u = part.range(Parameter::U);
    const Interval v = part.range(Parameter::V);
    int kept_moves = 0;
    int others = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const auto centre = [&]() -> Vec3 {
            const SurfaceTangents at =
                part.tangents(u.low, std::lerp(v.low, v.high, random.uniform(0.3, 0.5)));
            const Vec3 normal = side * at.du.cross(at.dv).normalized();
            const double beyond = random.uniform(1, 4);
            const double touching = std::sqrt(radius * radius - beyond * beyond);
            return at.point - beyond * at.du.normalized() +
                   (touching - random.uniform(0, 0.3)) * normal;
        };
        const BallMove move{centre(), centre()};
        if (gouge.test(move, depth).gouges != Answer::No)
            continue;
        const bool is_kept = border.is_kept(move);
        double deepest = 0;
        for (const double inset : {0.0, 1e-4, 2e-3, 0.01})
            test::for_each_beside_border(
                part, axis, 400, inset, [&](const Vec3& point, const Vec3& normal) {
                    const test::SampledMove sampled{move.from, move.to};
                    if (test::distance_to(point, sampled) < radius)
                        deepest = std::max(
                            deepest, test::normal_depth(sampled, radius, point, normal));
                });
        if (is_kept) {
            EXPECT_LE(deepest, depth);
        } else {
            EXPECT_GE(deepest, 0.99 * depth);
        }
        ++(is_kept ? kept_moves : others);
    }
    EXPECT_GE(kept_moves, 20);
    EXPECT_GE(others, 20);
}

TEST(BorderDepth, RefusesDepthsOutOfRange)
{
    const Surface part = test::plane(40, 30);
    for (const double depth : {0.0, -1.0, radius, std::nan("")})
        EXPECT_THROW(is_kept(part, {{0, 0, 9}, {1, 0, 9}}, depth), DomainError);
}

}  // namespace
}  // namespace endmill
