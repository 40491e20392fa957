// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/simple_shape.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/surface/nurbs.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

std::optional<SimpleShape> shape_of(const std::string& name)
{
    const test::SidedSurfaces part = test::dataset(name);
    return simple_shape(part.surfaces.front(), part.sides.front());
}

TEST(SimpleShapeOf, RecognisesTheShapesOfTheDatasets)
{
    const auto plane = shape_of("tilted-plane");
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->kind, ShapeKind::Plane);
    EXPECT_EQ(plane->curvature, 0);
    EXPECT_NEAR(plane->area, 30000, 1e-6);
    EXPECT_NEAR(plane->steepest.radians(), std::atan(0.75), 1e-9);

    const auto sphere = shape_of("sphere");
    ASSERT_TRUE(sphere);
    EXPECT_EQ(sphere->kind, ShapeKind::Sphere);
    EXPECT_NEAR(sphere->curvature, 1 / 25.0, 1e-12);
    EXPECT_NEAR(sphere->area, 625 * 4 * 0.8 * std::asin(0.8), 1e-6);
    EXPECT_NEAR(sphere->steepest.radians(), std::acos(0.36), 1e-7);

    const auto cylinder = shape_of("cylinder");
    ASSERT_TRUE(cylinder);
    EXPECT_EQ(cylinder->kind, ShapeKind::Cylinder);
    EXPECT_NEAR(cylinder->curvature, 1 / 20.0, 1e-12);
    EXPECT_NEAR(cylinder->steepest.radians(), std::acos(0.28), 1e-7);
}

TEST(SimpleShapeOf, IsConcaveFromTheOtherSide)
{
    for (const char* const name : {"sphere", "cylinder"}) {
        const test::SidedSurfaces part = test::dataset(name);
        const auto outside = simple_shape(part.surfaces.front(), part.sides.front());
        const auto inside = simple_shape(part.surfaces.front(), -part.sides.front());
        ASSERT_TRUE(inside);
        EXPECT_EQ(inside->kind, outside->kind);
        EXPECT_NEAR(inside->curvature, -outside->curvature, 1e-12);
        EXPECT_GT(inside->steepest.degrees(), 90);
    }
}

TEST(SimpleShapeOf, DoesNotRecogniseOtherSurfaces)
{
    for (const char* const name : {"saddle", "torus", "parabolic-cylinder", "wavy",
                                   "gaussian-bump", "valley", "net_rot24_7D"})
        EXPECT_FALSE(shape_of(name)) << name;
}

TEST(SimpleShapeOf, DoesNotRecogniseAPlaneWithASmallBump)
{
    const test::Rectangle over{{-1, 1}, {-1, 1}};
    const auto recognised = [&](double height) {
        return simple_shape(test::graph(test::monomial(3, 2, height), over), 1)
            .has_value();
    };
    EXPECT_TRUE(recognised(1e-10));
    EXPECT_FALSE(recognised(1e-7));
}

TEST(SimpleShapeOf, DoesNotRecogniseAFoldedPlane)
{
    std::vector<Vec3> net = test::polynomial_net(
        {test::monomial(1, 0, 1), test::monomial(0, 1, 1), test::Polynomial::Zero()},
        {{0, 1}, {0, 1}}, {2, 1});
    for (Vec3& point : net)
        point.x() = std::min(point.x(), 1 - point.x());
    EXPECT_FALSE(simple_shape(composite_bezier(2, 1, net), 1));
}

}  // namespace
}  // namespace endmill
