// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/contact_frame.h"

#include <cmath>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double R = 7.5;
constexpr double h = 0.5;

TEST(ContactFrameOf, ACylinderHasItsPrincipalDirections)
{
    const test::SidedSurfaces cylinder = test::dataset("cylinder");
    const ContactPlace place = contact_place(cylinder.part(), 0, {0.3, 0.7});
    const auto frame = contact_frame(cylinder.part(), test::usual_problem(), place);
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->k.least, 0, 1e-14);
    EXPECT_NEAR(frame->k.greatest, 1 / 20.0, 1e-14);
    EXPECT_NEAR(std::abs(frame->e1.x()), 1, 1e-12);
    EXPECT_NEAR(frame->e2.x(), 0, 1e-12);
    EXPECT_NEAR(frame->centre.tail<2>().norm(), 20 + R, 1e-12);
    const double a = std::sqrt(2 * R * h - h * h);
    EXPECT_NEAR(frame->half_axis_1, a, 1e-12);
    EXPECT_NEAR(frame->half_axis_2, a / std::sqrt((1 + R / 20) * (1 + h / 20)), 1e-12);
}

TEST(ContactFrameOf, AlongHasTheParametersOfTheHalfAxes)
{
    const test::SidedSurfaces part{{test::random_surface(3, {2, 2}, 2)}};
    for (const SurfacePoint at : {SurfacePoint{0.3, 0.6}, SurfacePoint{1.7, 0.2}}) {
        const auto frame = contact_frame(part.part(), {BallCutter{1}, 0.1},
                                         contact_place(part.part(), 0, at));
        ASSERT_TRUE(frame);
        const SurfaceTangents t = part.surfaces[0].tangents(at.u, at.v);
        const Vec3 first = frame->along_1.a * t.du + frame->along_1.b * t.dv;
        const Vec3 second = frame->along_2.a * t.du + frame->along_2.b * t.dv;
        EXPECT_LT((first - frame->half_axis_1 * frame->e1).norm(), 1e-12);
        EXPECT_LT((second - frame->half_axis_2 * frame->e2).norm(), 1e-12);
        EXPECT_NEAR(frame->e1.dot(frame->e2), 0, 1e-12);
    }
}

// Principal curvatures by the surface module, whose frame is another.
TEST(ContactFrameOf, HasThePrincipalCurvaturesOfTheSurface)
{
    const test::SidedSurfaces net = test::dataset("net_rot24_7D");
    for (const SurfacePoint at : {SurfacePoint{0.3, 0.6}, SurfacePoint{2.1, 1.4}}) {
        const auto frame = contact_frame(net.part(), test::usual_problem(),
                                         contact_place(net.part(), 0, at));
        ASSERT_TRUE(frame);
        const PrincipalCurvatures k = principal_curvatures(
            fundamental_forms(net.surfaces[0].jet(at.u, at.v), net.sides[0]));
        EXPECT_NEAR(frame->k.least, k.least, 1e-13);
        EXPECT_NEAR(frame->k.greatest, k.greatest, 1e-13);
    }
}

TEST(ContactFrameOf, IsMissingWhereTheBallDoesNotFit)
{
    const test::SidedSurfaces trough{{test::parabolic_cylinder(1 / 5.0, 10, 10)}};
    const auto at = [&](double u, double radius) {
        return contact_frame(trough.part(), {BallCutter{radius}, h},
                             contact_place(trough.part(), 0, {u, 0.5}))
            .has_value();
    };
    EXPECT_FALSE(at(0.5, R));
    EXPECT_TRUE(at(0.5, 4.9));
    EXPECT_TRUE(at(0.95, R));
}

TEST(ContactPlaceAt, ABorderTakesThePatchThatIsNamed)
{
    // Curvature 0 on one side and 1 / 50 on the other side of u = 1.
    std::vector<Vec3> net = test::polynomial_net(
        {test::monomial(1, 0, 1), test::monomial(0, 1, 1), test::Polynomial::Zero()},
        {{-10, 10}, {-10, 10}}, {2, 1});
    for (Vec3& point : net)
        if (point.x() > 5)
            point.z() = point.x() > 9 ? -1 : -1 / 3.0;
    const test::SidedSurfaces part{{composite_bezier(2, 1, net)}};
    const auto curvature = [&](int patch) {
        return contact_frame(part.part(), test::usual_problem(), {0, patch, 0, {1, 0.5}})
            ->k.greatest;
    };
    EXPECT_NEAR(curvature(0), 0, 1e-12);
    EXPECT_NEAR(curvature(1), 1 / 50.0, 1e-12);
}

TEST(WidestStripOf, AContactAndOfATip)
{
    const test::SidedSurfaces cylinder = test::dataset("cylinder");
    BoundProblem problem = test::usual_problem();
    const auto frame = contact_frame(cylinder.part(), problem,
                                     contact_place(cylinder.part(), 0, {0.3, 0.7}));
    EXPECT_NEAR(widest_strip(*frame, problem), 2 * frame->half_axis_1, 1e-12);
    problem.length = BoundedLength::Tip;
    EXPECT_NEAR(widest_strip(*frame, problem), 2 * frame->half_axis_2, 1e-12);
}

}  // namespace
}  // namespace endmill
