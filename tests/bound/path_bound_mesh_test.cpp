// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/path_bound.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "test_meshes.h"

namespace endmill {
namespace {

TriangleMesh plane(int columns, int rows, double slope)
{
    return test::grid_mesh(columns, rows, [=](int i, int j) {
        return Vec3{120.0 * i / columns, 80.0 * j / rows, slope * 120 * i / columns};
    });
}

double width()
{
    return 2 * plane_half_width(test::tip_problem());
}

// A / w and pi w / 4, however the plane is divided into triangles.
TEST(MeshBound, OfAPlaneIsTheClosedForm)
{
    for (const int columns : {1, 24, 120}) {
        const PathBound bound =
            mesh_bound(plane(columns, columns, 0), test::tip_problem());
        EXPECT_EQ(bound.grade, BoundGrade::Estimated);
        EXPECT_NEAR(bound.density_mm, 9600 / width(), 1e-3 * 9600 / width());
        EXPECT_NEAR(bound.disc_mm, std::numbers::pi / 4 * width(), 5e-3 * width());
        ASSERT_TRUE(bound.bound_mm);
        EXPECT_DOUBLE_EQ(*bound.bound_mm, bound.density_mm - bound.disc_mm);
    }
}

// Tips on a sphere of radius rho, convex or concave: A / (2 rho sin(alpha)) times
// (rho + R) / rho, or with -R. Source: docs/methods/path-length-bound.md, section 5.
TEST(MeshBound, OfASphereComesNearTheClosedForm)
{
    constexpr double rho = 50;
    constexpr double R = 7.5;
    constexpr double h = 0.5;
    for (const int side : {1, -1}) {
        const TriangleMesh mesh = test::grid_mesh(150, 150, [side](int i, int j) {
            const double x = (i - 75) / 3.0;
            const double y = (j - 75) / 3.0;
            return Vec3{x, y, side * std::sqrt(rho * rho - x * x - y * y)};
        });
        double area = 0;
        for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
            const auto [a, b, c] = mesh.corners(k);
            area += (b - a).cross(c - a).norm() / 2;
        }
        const double cosine =
            (std::pow(rho + side * h, 2) + std::pow(rho + side * R, 2) - R * R) /
            (2 * (rho + side * h) * (rho + side * R));
        const double density =
            area / (2 * rho * std::sin(std::acos(cosine))) * (rho + side * R) / rho;
        const PathBound bound = mesh_bound(mesh, test::tip_problem());
        EXPECT_LT(bound.density_mm, 1.001 * density);
        EXPECT_GT(bound.density_mm, 0.985 * density);
    }
}

// The bound of the saddle and of its mesh with a chord error of 0.01 mm.
TEST(MeshBound, OfASampledSaddleIsThatOfTheSurface)
{
    const test::SidedSurfaces saddle = test::dataset("saddle");
    const Surface& surface = saddle.surfaces.front();
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    const TriangleMesh mesh = test::grid_mesh(96, 96, [&](int i, int j) -> Vec3 {
        return surface
            .tangents(std::lerp(u.low, u.high, i / 96.0),
                      std::lerp(v.low, v.high, j / 96.0))
            .point;
    });
    BoundProblem problem = test::tip_problem();
    problem.stray = 0.01;
    const PathBound of_surface = path_bound(saddle.surfaces, saddle.sides, problem);
    const PathBound of_mesh = mesh_bound(mesh, problem);
    EXPECT_NEAR(of_mesh.density_mm, of_surface.density_mm, 0.01 * of_surface.density_mm);
    EXPECT_NEAR(of_mesh.disc_mm, of_surface.disc_mm, 0.02 * of_surface.disc_mm);
}

// A ridge takes little: the bound of a roof is near that of its two planes.
TEST(MeshBound, OfARoofIsNearThatOfItsPlanes)
{
    const TriangleMesh roof = test::grid_mesh(2, 2, [](int i, int j) {
        return Vec3{60.0 * i, 40.0 * j, j == 1 ? 30.0 : 0.0};
    });
    const double planes = 120 * 100 / width();
    const PathBound bound = mesh_bound(roof, test::tip_problem());
    EXPECT_LT(bound.density_mm, 1.02 * planes);
    EXPECT_GT(bound.density_mm, 0.9 * planes);
}

// A ball that may gouge covers more, and tips beside edges travel less.
TEST(MeshBound, FallsWithWhatThePathMayStray)
{
    BoundProblem problem = test::tip_problem();
    problem.stray = 0.05;
    const double factor = 1 - 0.05 / 7.5;
    const double wider = 2 * plane_half_width(problem);
    EXPECT_NEAR(mesh_bound(plane(1, 1, 0), problem).density_mm, factor * 9600 / wider,
                1e-3 * 9600 / wider);
}

TEST(MeshBound, HasTheSameNumbersForAnyNumberOfThreads)
{
    const TriangleMesh mesh = plane(7, 5, 0.3);
    EstimateOptions options;
    options.random_places = 1000;
    set_thread_count(1);
    const PathBound one = mesh_bound(mesh, test::tip_problem(), options);
    set_thread_count(3);
    const PathBound three = mesh_bound(mesh, test::tip_problem(), options);
    EXPECT_EQ(one.density_mm, three.density_mm);
    EXPECT_EQ(one.disc_mm, three.disc_mm);
}

TEST(MeshBound, RefusesContactsAndMeshesThatDoNotFaceTheTool)
{
    EXPECT_THROW(mesh_bound(plane(1, 1, 0), test::usual_problem()), DomainError);
    const TriangleMesh up = plane(1, 1, 0);
    std::vector<Triangle> turned(up.triangles().begin(), up.triangles().end());
    for (Triangle& triangle : turned)
        std::swap(triangle[0], triangle[1]);
    EXPECT_THROW(mesh_bound({{up.points().begin(), up.points().end()}, turned},
                            test::tip_problem()),
                 GeometryError);
    // a slot narrower than the ball: it fits on the floor nowhere
    const TriangleMesh slot = test::grid_mesh(3, 1, [](int i, int j) {
        return Vec3{i < 2 ? 0.0 : 4.0, 40.0 * j, i == 0 || i == 3 ? 60.0 : 0.0};
    });
    EXPECT_THROW(mesh_bound(slot, test::tip_problem()), GeometryError);
}

}  // namespace
}  // namespace endmill
