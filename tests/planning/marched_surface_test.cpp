// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/marched_surface.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(MarchedSurface, KeepsPointsAndNormalsForBothDirections)
{
    const Surface part = test::saddle(40, 50, {2, 2});
    for (const Parameter direction : {Parameter::U, Parameter::V}) {
        const MarchedSurface marched = marched_surface(part, 1, direction);
        const SurfacePoint at{0.3, 1.4};
        const SurfacePoint original = in_surface_order(at, direction);
        const SurfaceTangents found = marched.surface.tangents(at.u, at.v);
        const SurfaceTangents expected = part.tangents(original.u, original.v);
        EXPECT_LT((found.point - expected.point).norm(), 1e-12);
        EXPECT_LT(
            (marched.side * found.du.cross(found.dv) - expected.du.cross(expected.dv))
                .norm(),
            1e-9);
    }
}

TEST(InSurfaceOrder, ExchangesTheParametersOfPassesAlongV)
{
    const SurfacePoint along_u = in_surface_order({1, 2}, Parameter::U);
    const SurfacePoint along_v = in_surface_order({1, 2}, Parameter::V);
    EXPECT_EQ(along_u.u, 1);
    EXPECT_EQ(along_u.v, 2);
    EXPECT_EQ(along_v.u, 2);
    EXPECT_EQ(along_v.v, 1);
}

}  // namespace
}  // namespace endmill
