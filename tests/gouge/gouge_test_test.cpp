// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/gouge_test.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/gouge/detail/piece_tree.h"
#include "endmill/gouge/detail/swept_axis.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double rho = 20;
const Vec3 up = Vec3::UnitZ();

GougeTest test_on(const std::vector<Surface>& surfaces, const Vec3& axis = up)
{
    return GougeTest{surfaces, BallCutter{radius}, axis};
}

Answer gouges(const GougeTest& gouge, const BallMove& move, double tolerance)
{
    return gouge.test(move, tolerance).gouges;
}

TEST(GougeTest, OfALoweredBallIsTheLowering)
{
    const GougeTest gouge = test_on({test::plane(60, 40)});
    const BallMove move{{10, 20, radius - 0.25}, {40, 25, radius - 0.25}};
    EXPECT_NEAR(gouge.deepest(move, 1e-6)->depth_mm, 0.25, 2e-6);
    EXPECT_EQ(gouges(gouge, move, 0.2504), Answer::No);
    EXPECT_EQ(gouges(gouge, move, 0.2496), Answer::Yes);
    EXPECT_NE(gouges(gouge, move, 0.25), Answer::No);
    const BallMove above{{10, 20, radius + 1}, {40, 25, radius + 1}};
    EXPECT_FALSE(gouge.deepest(above, 1e-9));
}

// The parallel plane is exact on a flat face. Pieces of the size at which the plane across
// the distance decides, about 1e-4 mm, would be millions along these moves.
TEST(GougeTest, OfALongMoveOnAFlatFaceNeedsFewPiecesAtATinyTolerance)
{
    constexpr double tolerance = 1e-9;
    const Vec3 leaning = Vec3{0.1, -0.6, 0.8}.normalized();
    const Eigen::Matrix3d tilt =
        Eigen::AngleAxisd{0.5, Vec3{1, 2, 0}.normalized()}.toRotationMatrix();
    const auto tilted = [&](double u, double v, double w) -> Vec3 {
        return tilt * Vec3{u, v, w};
    };
    const std::vector<Surface> part{
        test::parallelogram(tilted(200, 0, 0), tilted(60, 120, 0))};
    for (const Vec3& axis : {up, leaning}) {
        const GougeTest gouge = test_on(part, axis);
        for (const double lowered : {0.0, 0.5, 0.99}) {
            const double height = radius - lowered * tolerance;
            FinerPieces finer;
            EXPECT_EQ(gouge
                          .test({tilted(20, 20, height), tilted(220, 70, height)},
                                tolerance, finer)
                          .gouges,
                      Answer::No);
            EXPECT_FALSE(finer.is_full());
        }
        const double below = radius - 1.01 * tolerance;
        EXPECT_EQ(
            gouges(gouge, {tilted(20, 20, below), tilted(220, 70, below)}, tolerance),
            Answer::Yes);
    }
}

// The centres move on a chord of a circle of radius rho + R, so that the depth is the
// sagitta.
TEST(GougeTest, OfAChordOverACylinderIsTheSagittaOfTheCentres)
{
    const GougeTest gouge = test_on({nurbs_surface(
        test::cylinder(rho, 50, std::numbers::pi / 6, std::numbers::pi * 5 / 6))});
    for (const double angle : {0.02, 0.2, 0.4}) {
        const auto centre = [&](double sign) -> Vec3 {
            const double at = std::numbers::pi / 2 + sign * angle / 2;
            return (rho + radius) * Vec3{0, std::cos(at), std::sin(at)} +
                   25 * Vec3::UnitX();
        };
        const BallMove move{centre(1), centre(-1)};
        const double depth = (rho + radius) * (1 - std::cos(angle / 2));
        EXPECT_NEAR(gouge.deepest(move, 1e-6)->depth_mm, depth, 2e-6);
        EXPECT_EQ(gouges(gouge, move, 1.01 * depth), Answer::No);
        EXPECT_EQ(gouges(gouge, move, 0.99 * depth), Answer::Yes);
    }
}

TEST(GougeTest, SeesTheShankEnterAWallBesideIt)
{
    const double gap = radius - 0.3;
    const std::vector<Surface> part{
        test::plane(60, 40),
        test::polynomial_surface(
            {test::monomial(1, 0, 60), test::monomial(0, 0, 20 + gap),
             test::monomial(0, 0, 30) + test::monomial(0, 1, 20)},
            {{0, 1}, {0, 1}})};
    const GougeTest gouge = test_on(part);
    const BallMove move{{10, 20, radius}, {50, 20, radius}};
    const auto deepest = gouge.deepest(move, 1e-6);
    EXPECT_NEAR(deepest->depth_mm, 0.3, 2e-6);
    EXPECT_EQ(deepest->surface, 1U);
    EXPECT_EQ(gouges(gouge, move, 0.2), Answer::Yes);
    EXPECT_EQ(gouges(gouge, move, 0.31), Answer::No);
    // With this axis the shank leans away from the wall.
    const GougeTest tilted = test_on(part, Vec3{0, -0.6, 0.8});
    EXPECT_EQ(gouges(tilted, move, 0.01), Answer::No);
}

// The largest depth of 161 by 161 samples of a surface, over 0 … 2 in u and in v.
double sampled_depth(const Surface& surface, const BallMove& move)
{
    constexpr int count = 160;
    const SweptAxis swept{move.from, move.to, up};
    double deepest = 0;
    for (int i = 0; i <= count; ++i)
        for (int j = 0; j <= count; ++j) {
            const Vec3 point = surface.tangents(2.0 * i / count, 2.0 * j / count).point;
            deepest = std::max(deepest, radius - (point - swept.nearest(point)).norm());
        }
    return deepest;
}

// Between two points the depth changes by at most their distance, so that dense samples
// bound it.
TEST(GougeTest, AgreesWithDenseSamplesOnRandomSurfaces)
{
    test::Random random{11};
    for (unsigned seed = 0; seed < 6; ++seed) {
        const std::vector<Surface> part{
            seed % 2 == 0
                ? test::random_surface(seed, {2, 2})
                : Surface{{0, 2}, {0, 2}, {test::random_patch(seed, 3, 4, true)}}};
        const GougeTest gouge = test_on(part);
        for (int k = 0; k < 5; ++k) {
            const BallMove move{
                {random.uniform(5, 40), random.uniform(5, 40), radius - 1},
                {random.uniform(5, 40), random.uniform(5, 40), radius}};
            const double sampled = sampled_depth(part[0], move);
            const auto deepest = gouge.deepest(move, 1e-6);
            const double depth = deepest ? deepest->depth_mm : 0;
            EXPECT_GE(depth, sampled - 1e-6);
            EXPECT_LE(depth, sampled + 0.4);  // pitch: 60 / 160 mm
            if (deepest) {
                const Vec3 there = part[0].tangents(deepest->at.u, deepest->at.v).point;
                EXPECT_LT((there - deepest->point).norm(), 1e-9);
                EXPECT_EQ(gouges(gouge, move, 1.01 * depth + 1e-3), Answer::No);
                if (depth > 0.01) {
                    EXPECT_EQ(gouges(gouge, move, 0.99 * depth), Answer::Yes);
                }
            }
        }
    }
}

TEST(GougeTest, ResultDoesNotDependOnKeptPieces)
{
    const GougeTest gouge = test_on({test::random_surface(5, {2, 2})});
    FinerPieces finer;
    for (int k = 0; k < 200; ++k) {
        const BallMove move{{10, 10 + 0.1 * k, radius}, {40, 30, radius + 0.02 * k}};
        EXPECT_EQ(gouge.test(move, 0.01 + 0.01 * k, finer).gouges,
                  gouges(gouge, move, 0.01 + 0.01 * k));
    }
}

TEST(GougeTest, RefusesTolerancesOutOfRange)
{
    const GougeTest gouge = test_on({test::plane(10, 10)});
    const BallMove move{{1, 1, radius}, {2, 2, radius}};
    for (const double tolerance : {0.0, -1.0, radius, std::nan("")})
        EXPECT_THROW(gouge.test(move, tolerance), DomainError);
    EXPECT_THROW(gouge.deepest(move, 0), DomainError);
}

}  // namespace
}  // namespace endmill
