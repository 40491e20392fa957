// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface_jet.h"

#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(SurfaceJet, NormalIsWhatGramAndSchmidtLeaveOfAThirdDirection)
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

// Partials of the given lengths at an angle whose sine is `sine`.
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

TEST(SurfaceJet, APartialThatIsNoNumberIsSingular)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(is_singular({Vec3::Zero(), {nan, 0, 0}, {0, 1, 0}}));
}

}  // namespace
}  // namespace endmill
