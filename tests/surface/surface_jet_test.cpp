// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface_jet.h"

#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(SurfaceJet, NormalIsThatOfGramSchmidt)
{
    test::Random random{1};
    const auto vector = [&] {
        return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    for (int k = 0; k < 1000; ++k) {
        const SurfaceTangents tangents{vector(), vector(), vector()};
        const Vec3 first = tangents.du.normalized();
        const Vec3 second = (tangents.dv - first.dot(tangents.dv) * first).normalized();
        Vec3 left = vector();
        left -= first.dot(left) * first;
        left -= second.dot(left) * second;
        Eigen::Matrix3d frame;
        frame << tangents.du, tangents.dv, left;
        const Vec3 expected =
            frame.determinant() > 0 ? left.normalized() : -left.normalized();
        EXPECT_LT((unit_normal(tangents) - expected).norm(), 1e-10) << k;
    }
}

// Partial derivatives of the given lengths, at an angle with this sine.
SurfaceTangents partials(double du, double dv, double sine)
{
    return {Vec3::Zero(), {du, 0, 0}, {dv, dv * sine, 0}};
}

TEST(SurfaceJet, IsSingularBelowASineOfTenToTheMinusTenWhateverTheLengths)
{
    for (const double du : {1e-60, 1.0, 1e60})
        for (const double dv : {1e-60, 1.0, 1e60}) {
            EXPECT_TRUE(is_singular(partials(du, dv, 0.9e-10))) << du << ' ' << dv;
            EXPECT_FALSE(is_singular(partials(du, dv, 1.1e-10))) << du << ' ' << dv;
        }
}

TEST(SurfaceJet, IsSingularWhereAPartialVanishesOrBothAreParallel)
{
    const Vec3 x{3, 4, 5};
    for (const SurfaceTangents& tangents :
         {SurfaceTangents{x, Vec3::Zero(), x}, SurfaceTangents{x, x, Vec3::Zero()},
          SurfaceTangents{x, Vec3::Zero(), Vec3::Zero()},
          SurfaceTangents{x, x, -2 * x}}) {
        EXPECT_TRUE(is_singular(tangents));
        EXPECT_THROW(unit_normal(tangents), GeometryError);
    }
}

TEST(SurfaceJet, APartialThatIsNaNIsSingular)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(is_singular({Vec3::Zero(), {nan, 0, 0}, {0, 1, 0}}));
}

// At the pole of (x, x y, f) the normal along the line v = y is the limit of the normals
// beside it.
TEST(LimitNormal, AtAPoleIsTheLimitOfTheNormalsBesideIt)
{
    const test::Polynomial height = test::monomial(1, 2, 0.4) + test::monomial(2, 1, 0.3);
    for (const bool at_upper_end : {false, true}) {
        const test::Rectangle over{at_upper_end ? Interval{-1, 0} : Interval{0, 1},
                                   {0, 1}};
        const Surface fan = test::polynomial_surface(
            {test::monomial(1, 0, 1), test::monomial(1, 1, 1), height}, over);
        const double pole = at_upper_end ? 1 : 0;
        const int inward = at_upper_end ? -1 : 1;
        for (const double v : {0.0, 0.3, 1.0}) {
            const auto limit = limit_normal(fan.jet(pole, v), {inward, 1});
            ASSERT_TRUE(limit);
            double last = 1;
            for (const double near : {1e-2, 1e-4, 1e-6}) {
                const Vec3 beside = unit_normal(fan.tangents(pole + inward * near, v));
                EXPECT_LT((beside - *limit).norm(), 2 * near);
                last = (beside - *limit).norm();
            }
            EXPECT_LT(last, 1e-5);
        }
    }
}

TEST(LimitNormal, AtAPoleOfTheOtherParameterIsTheSameTurnedRound)
{
    const Surface fan = test::polynomial_surface(
        {test::monomial(1, 0, 1), test::monomial(1, 1, 1), test::monomial(1, 2, 0.4)},
        {{0, 1}, {0, 1}});
    const auto along_u = limit_normal(fan.jet(0, 0.6), {1, 1});
    const auto along_v = limit_normal(transposed(fan).jet(0.6, 0), {1, 1});
    ASSERT_TRUE(along_u && along_v);
    EXPECT_LT((*along_u + *along_v).norm(), 1e-14);
}

TEST(LimitNormal, WhereThereIsANormalIsTheNormal)
{
    const SurfaceJet jet = test::random_surface(1).jet(0.3, 0.4);
    EXPECT_EQ(limit_normal(jet, {1, -1}), unit_normal({jet.point, jet.du, jet.dv}));
}

TEST(LimitNormal, DoesNotExistOnACuspOrAPoint)
{
    const Vec3 x = Vec3::UnitX();
    const Vec3 zero = Vec3::Zero();
    EXPECT_FALSE(limit_normal({zero, x, -2 * x, zero, Vec3::UnitY(), zero}, {1, 1}));
    EXPECT_FALSE(limit_normal({zero, x, zero, zero, 3 * x, zero}, {1, 1}));
    EXPECT_FALSE(limit_normal({zero, zero, zero, zero, zero, zero}, {1, 1}));
}

}  // namespace
}  // namespace endmill
