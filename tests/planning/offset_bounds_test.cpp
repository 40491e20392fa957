// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/offset_bounds.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/planning/detail/contact_line.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// Greatest distance of the offset from the bilinear patch through its corners, as a share
// of the bound, over random cells of every rectangle.
double greatest_share(const Surface& surface, double height)
{
    const MarchedSurface marched{surface, 1};
    const OffsetBounds bounds{surface};
    const Interval all = surface.range(Parameter::V);
    test::Random random{1};
    double greatest = 0;
    for (const OffsetBends& bends : bounds.across(all)) {
        const auto inside = [&](double low, double high) {
            return random.uniform(low, high);
        };
        const double u0 = inside(bends.low.u, bends.high.u);
        const double u1 = inside(u0, bends.high.u);
        const double v0 = inside(bends.low.v, bends.high.v);
        const double v1 = inside(v0, bends.high.v);
        const auto offset = [&](double u, double v) -> Vec3 {
            const CutterContact contact =
                contact_at(marched, {u, v}, Parameter::U).contact;
            return contact.point + height * contact.normal;
        };
        for (int k = 1; k < 20; ++k) {
            const double s = k / 20.0;
            const double t = (k * 7 % 20) / 20.0;
            const Vec3 bilinear =
                (1 - t) * ((1 - s) * offset(u0, v0) + s * offset(u1, v0)) +
                t * ((1 - s) * offset(u0, v1) + s * offset(u1, v1));
            const Vec3 point = offset(std::lerp(u0, u1, s), std::lerp(v0, v1, t));
            greatest = std::max(greatest, ((point - bilinear).norm() - 1e-12) /
                                              bends.deviation(u1 - u0, v1 - v0, height));
        }
    }
    return greatest;
}

TEST(OffsetBounds, HoldOnCurvedSurfaces)
{
    for (const double height : {0.0, 1.0, 20.0}) {
        EXPECT_LE(greatest_share(test::random_surface(2, {2, 2}, 2), height), 1);
        EXPECT_LE(
            greatest_share(nurbs_surface(test::torus(20, 5, {0, 2, 0.2, 2, 2})), height),
            1);
        const Surface rational{{0, 3}, {-1, 1}, {test::random_patch(6, 3, 2, true, 2)}};
        EXPECT_LE(greatest_share(rational, height), 1);
    }
}

TEST(OffsetBounds, HoldNextToAPole)
{
    const Surface octant =
        nurbs_surface(test::torus(0, 10, {0, 1.5, 0, std::numbers::pi / 2}));
    const double share = greatest_share(octant, 1);
    EXPECT_LE(share, 1);
    EXPECT_GT(share, 0);  // so that the bounds there are finite
}

TEST(OffsetBounds, AreTightOnACylinder)
{
    // With the angle t, the second derivative of the offset is about (rho + h) (dt /
    // dv)^2.
    const Surface part = nurbs_surface(test::cylinder(20, 30, 1.4, 1.7));
    EXPECT_GT(greatest_share(part, 5), 0.3);
}

TEST(OffsetBounds, GiveTheRectangleOfAPlace)
{
    const Surface surface = test::random_surface(2, {3, 2}, 2);
    const OffsetBounds bounds{surface};
    for (const double u : {0.0, 0.3, 1.0, 1.75, 3.0})
        for (const double v : {0.0, 0.25, 1.0, 1.99, 2.0}) {
            const OffsetBends& bends = bounds.at(u, v);
            EXPECT_LE(bends.low.u, u);
            EXPECT_LE(u, bends.high.u);
            EXPECT_LE(bends.low.v, v);
            EXPECT_LE(v, bends.high.v);
        }
    for (const OffsetBends& bends : bounds.across({0.3, 0.6})) {
        EXPECT_LT(bends.low.v, 0.6);
        EXPECT_GT(bends.high.v, 0.3);
    }
}

}  // namespace
}  // namespace endmill
