// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/mesh_shape.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_meshes.h"

namespace endmill {
namespace {

using Height = std::function<double(double x, double y)>;

// The graph of a function over [-10, 10]^2 with cells of 20 / `cells` mm.
TriangleMesh graph(int cells, const Height& height)
{
    return test::grid_mesh(cells, cells, [&](int i, int j) {
        const double x = 20.0 * i / cells - 10;
        const double y = 20.0 * j / cells - 10;
        return Vec3{x, y, height(x, y)};
    });
}

double sphere(double x, double y)
{
    return std::sqrt(900 - x * x - y * y) - 30;
}

// The greatest errors of normal and tensor away from the border, on a sphere of radius 30.
struct ShapeError {
    double normal = 0;
    double tensor = 0;  // relative
};
ShapeError error_on_sphere(int cells)
{
    const TriangleMesh mesh = graph(cells, sphere);
    const MeshShape shape{mesh};
    ShapeError error;
    for (std::size_t facet = 0; facet < mesh.triangles().size(); ++facet) {
        const ShapePlace at = shape.middle(facet);
        if (std::max(std::abs(at.point.x()), std::abs(at.point.y())) > 6)
            continue;
        const Vec3 normal = (at.point + Vec3{0, 0, 30}).normalized();
        const Eigen::Matrix3d tensor =
            (Eigen::Matrix3d::Identity() - normal * normal.transpose()) / 30;
        error.normal = std::max(error.normal, (at.normal - normal).norm());
        error.tensor = std::max(error.tensor, 30 * (at.tensor - tensor).norm());
    }
    return error;
}

// The errors fall with the square of the spacing.
TEST(MeshShape, ApproachesNormalsAndCurvaturesOfASphere)
{
    const ShapeError coarse = error_on_sphere(10);
    const ShapeError fine = error_on_sphere(40);
    EXPECT_LT(coarse.normal, 5e-3);
    EXPECT_LT(coarse.tensor, 0.05);
    EXPECT_LT(fine.normal, coarse.normal / 8);
    EXPECT_LT(fine.tensor, coarse.tensor / 8);
}

TEST(MeshShape, HasTheCurvaturesOfASaddle)
{
    const TriangleMesh mesh =
        graph(40, [](double x, double y) { return 0.01 * x * x - 0.02 * y * y; });
    const MeshShape shape{mesh};
    const ShapePlace top = shape.nearest({0, 0, 0});
    EXPECT_NEAR(top.point.norm(), 0, 1e-12);
    EXPECT_NEAR((top.normal - Vec3::UnitZ()).norm(), 0, 1e-3);
    // concave along x, convex along y
    EXPECT_NEAR(top.tensor(0, 0), -0.02, 4e-4);
    EXPECT_NEAR(top.tensor(1, 1), 0.04, 8e-4);
    EXPECT_NEAR(top.tensor(0, 1), 0, 4e-4);
}

// Sharp edges do not bend the faces beside them.
TEST(MeshShape, IsPlaneUpToTheEdgesOfABox)
{
    const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {10, 20, 30});
    const MeshShape shape{mesh};
    for (const double x : {0.01, 5.0, 9.99}) {
        const ShapePlace at = shape.nearest({x, 3, 31});
        EXPECT_NEAR((at.normal - Vec3::UnitZ()).norm(), 0, 1e-12);
        EXPECT_NEAR(at.tensor.norm(), 0, 1e-12);
    }
}

}  // namespace
}  // namespace endmill
