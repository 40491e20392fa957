// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_point.h"

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(RaisedJetOf, ASphereLiesOnALargerSphere)
{
    const test::SidedSurfaces sphere = test::dataset("sphere");
    const RaisedJet jet = raised_jet(sphere.part(), 0, {0.3, 0.8}, 0.5);
    EXPECT_NEAR(jet.point.norm(), 25.5, 1e-12);
    EXPECT_LT((jet.du - 25.5 / 25 * jet.surface_du).norm(), 1e-12);
    EXPECT_LT((jet.dv - 25.5 / 25 * jet.surface_dv).norm(), 1e-12);
}

TEST(RaisedJetOf, AnySurfaceHasTheDerivativesOfItsDifferences)
{
    const test::SidedSurfaces part{{test::random_surface(5, {2, 2}, 3)}};
    constexpr double step = 1e-5;
    for (const SurfacePoint at : {SurfacePoint{0.3, 0.6}, SurfacePoint{1.7, 1.2}}) {
        const RaisedJet jet = raised_jet(part.part(), 0, at, 0.7);
        const auto point = [&](double u, double v) {
            return raised_place(part.part(), 0, {at.u + u, at.v + v}, 0.7).point;
        };
        const Vec3 du = (point(step, 0) - point(-step, 0)) / (2 * step);
        const Vec3 dv = (point(0, step) - point(0, -step)) / (2 * step);
        EXPECT_LT((jet.du - du).norm(), 1e-7 * du.norm());
        EXPECT_LT((jet.dv - dv).norm(), 1e-7 * dv.norm());
    }
}

TEST(RaisedPlaceOf, EqualsTheJetWithoutItsDerivatives)
{
    const test::SidedSurfaces part{{test::random_surface(6, {1, 1}, 3)}};
    const RaisedJet jet = raised_jet(part.part(), 0, {0.4, 0.9}, 0.7);
    const RaisedPlace place = raised_place(part.part(), 0, {0.4, 0.9}, 0.7);
    EXPECT_LT((jet.point - place.point).norm(), 1e-12);
    EXPECT_NEAR(jet.area, place.area, 1e-12 * jet.area);
    EXPECT_NEAR(jet.area, jet.surface_du.cross(jet.surface_dv).norm(), 1e-12 * jet.area);
}

TEST(RaisedPlaceOf, APoleHasNoArea)
{
    std::vector<Vec3> net = test::random_net(1, {1, 1}, 1);
    for (std::size_t k = 1; k < 4; ++k)
        net[k] = net[0];
    const test::SidedSurfaces part{{composite_bezier(1, 1, net)}};
    EXPECT_EQ(raised_place(part.part(), 0, {0.5, 0}, 0.5).area, 0);
    EXPECT_EQ(raised_jet(part.part(), 0, {0.5, 0}, 0.5).area, 0);
}

}  // namespace
}  // namespace endmill
