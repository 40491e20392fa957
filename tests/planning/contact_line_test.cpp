// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/contact_line.h"

#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(ContactLine, OfASphereHasTheCentresOfALargerSphere)
{
    const MarchedSurface sphere{
        nurbs_surface(test::torus(0, 20, {0, 1, 0, std::numbers::pi / 2})), 1};
    const BallCutter ball{5};
    for (const double v : {0.0, 0.4, 0.8, 1.0}) {  // the last is the pole
        const ContactLine line{sphere, v, Parameter::U};
        EXPECT_EQ(line.is_point(), v == 1);
        for (const double u : {0.0, 0.3, 1.0}) {
            const SurfaceContact contact = line.at(u);
            EXPECT_NEAR(ball_centre(contact, ball).norm(), 25, 1e-9);
            EXPECT_LT((contact.contact.point - line.point(u)).norm(), 1e-12);
            const SurfaceContact same = contact_at(sphere, {u, v}, Parameter::U);
            EXPECT_LT((same.contact.normal - contact.contact.normal).norm(), 1e-9);
        }
    }
}

TEST(ContactLine, ReportsThePlaceWithoutANormal)
{
    std::vector<Vec3> net(16, Vec3::Zero());
    for (int k = 0; k < 16; ++k)
        net[k] = {double(k % 4), 0, 0};  // a line
    const MarchedSurface marched{composite_bezier(1, 1, net), 1};
    const ContactLine line{marched, 0.5, Parameter::U};
    EXPECT_THROW(line.at(0.5), GeometryError);
}

}  // namespace
}  // namespace endmill
