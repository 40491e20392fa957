// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/patch_offset.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double rho = 20;

TEST(PatchOffset, OfACylinderIsACylinder)
{
    const Surface part = nurbs_surface(test::cylinder(rho, 30, 0.6, 2.5, 2));
    for (const double height : {3.0, 0.0, -3.0}) {
        double greatest = 0;
        double least = 1e9;
        const MarchedSurface marched{part, 1};
        const Interval u = part.range(Parameter::U);
        const Interval v = part.range(Parameter::V);
        const PatchOffset offset{marched, {u.low + 1e-3, v.low + 1e-3}, height};
        for (const double share : {0.0, 0.2, 0.5}) {
            const auto point = offset.at(std::lerp(u.low, u.high, share),
                                         std::lerp(v.low, v.high, share));
            ASSERT_TRUE(point);
            const double distance = std::hypot(point->y(), point->z());
            greatest = std::max(greatest, distance);
            least = std::min(least, distance);
        }
        EXPECT_NEAR(greatest - least, 0, 1e-9);
        EXPECT_NEAR(std::abs(greatest - rho), std::abs(height), 1e-9);
    }
}

// In the crease of a valley each patch has its own normal.
TEST(PatchOffset, TakesTheNormalsOfItsPatch)
{
    const MarchedSurface marched{test::valley(30, 20, 1), 1};
    const auto u = marched.surface.breaks(Parameter::U);
    ASSERT_EQ(u.size(), 3U);
    const auto at_crease = [&](double inside) -> Vec3 {
        return *PatchOffset{marched, {inside, 0.5}, 1}.at(u[1], 0.5) -
               marched.surface.tangents(u[1], 0.5).point;
    };
    const Vec3 low = at_crease((u[0] + u[1]) / 2);
    const Vec3 high = at_crease((u[1] + u[2]) / 2);
    EXPECT_NEAR(low.dot(high), 0, 1e-12);  // slopes of 45 degrees
    EXPECT_NEAR(low.norm(), 1, 1e-12);
    EXPECT_NEAR(high.norm(), 1, 1e-12);
}

TEST(PatchOffset, HasALimitOnACollapsedEdge)
{
    const MarchedSurface marched{
        nurbs_surface(test::torus(0, rho, {0, 1.5, 0.5, std::numbers::pi / 2})), 1};
    const Interval u = marched.surface.range(Parameter::U);
    const Interval v = marched.surface.range(Parameter::V);
    const PatchOffset offset{
        marched, {(u.low + u.high) / 2, std::nextafter(v.high, v.low)}, 2};
    const auto pole = offset.at((u.low + u.high) / 2, v.high);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(std::hypot(pole->x(), pole->y()), 0, 1e-9);
    EXPECT_NEAR(std::abs(std::abs(pole->z()) - rho), 2, 1e-9);
}

}  // namespace
}  // namespace endmill
