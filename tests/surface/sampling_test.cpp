// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/sampling.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/triangle_tree.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/tool_side.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

SampledSurface sampled_up(const std::vector<Surface>& surfaces, double tolerance)
{
    return sampled(surfaces, tool_side_signs(surfaces, Vec3::UnitZ()), tolerance);
}

// Greatest distance between many places of the surface and the mesh.
double measured_error(const Surface& surface, const TriangleMesh& mesh)
{
    const TriangleTree tree{mesh};
    const auto [u_low, u_high] = surface.range(Parameter::U);
    const auto [v_low, v_high] = surface.range(Parameter::V);
    test::Random random{1};
    double worst = 0;
    for (int k = 0; k < 4000; ++k) {
        const Vec3 point =
            surface.tangents(random.uniform(u_low, u_high), random.uniform(v_low, v_high))
                .point;
        worst = std::max(worst, tree.nearest(point)->distance);
    }
    return worst;
}

TEST(Sampling, KeepsItsToleranceOnEveryKindOfSurface)
{
    std::vector<double> x(9);
    std::vector<double> z;
    for (int k = 0; k < 9; ++k)
        x[k] = 5.0 * k;
    for (const double b : x)
        for (const double a : x)
            z.push_back(4 * std::sin(0.2 * a) * std::cos(0.17 * b));
    const std::vector<Surface> kinds{
        test::random_surface(1, {3, 2}), height_grid(x, x, z),
        nurbs_surface(test::torus(30, 10, {0, 2, 0.3, 2.4, 2})),
        nurbs_surface(test::cylinder(10, 30, 0.2, 2.5)),
        Surface{{0, 1}, {0, 1}, {test::random_patch(3, 7, 4, true)}}};
    for (const Surface& surface : kinds)
        for (const double tolerance : {1.0, 0.1, 0.01}) {
            const SampledSurface found = sampled_up({surface}, tolerance);
            EXPECT_LE(found.max_chord_error_mm, tolerance);
            EXPECT_LE(measured_error(surface, found.mesh), found.max_chord_error_mm);
            EXPECT_EQ(found.normals.size(), found.mesh.points().size());
            const MeshReport report = mesh_report(found.mesh);
            EXPECT_EQ(report.components, 1U);
            EXPECT_EQ(report.non_manifold_edges, 0U);
            EXPECT_EQ(report.inconsistent_edges, 0U);
            EXPECT_EQ(report.degenerate_triangles, 0U);
        }
}

// For a disc V - E + F = 1, and the border is a single loop.
TEST(Sampling, IsADiscWithoutCracks)
{
    for (const double tolerance : {2.0, 0.1, 0.02}) {
        const SampledSurface found =
            sampled_up({test::random_surface(4, {4, 3}, 6)}, tolerance);
        const MeshReport report = mesh_report(found.mesh);
        const double faces = double(found.mesh.triangles().size());
        const double edges = (3 * faces + double(report.boundary_edges)) / 2;
        EXPECT_EQ(double(found.mesh.points().size()) - edges + faces, 1);
    }
}

TEST(Sampling, OfAPlaneIsTwoTrianglesAPatchWhateverTheTolerance)
{
    const SampledSurface found = sampled_up({test::plane(40, 30, {2, 2})}, 1e-9);
    EXPECT_EQ(found.mesh.triangles().size(), 8U);
    EXPECT_NEAR(mesh_report(found.mesh).area, 1200, 1e-9);
    EXPECT_NEAR(found.max_chord_error_mm, 0, 1e-12);
}

TEST(Sampling, ErrorFallsWithTheCellsAndAreaConverges)
{
    const Surface surface = nurbs_surface(test::torus(30, 10, {0, 2, 0.4, 2.3, 2}));
    const double exact = area(surface);
    double before = 0;
    for (const double tolerance : {0.4, 0.1, 0.025}) {
        const SampledSurface found = sampled_up({surface}, tolerance);
        const double off = std::abs(mesh_report(found.mesh).area - exact);
        EXPECT_LT(off, 0.1 * tolerance * exact);
        if (before > 0) {
            EXPECT_GT(before / off, 2);
        }
        before = off;
    }
}

TEST(Sampling, NormalsAndTrianglesAreOnTheToolsSide)
{
    for (const ToolSide side : {ToolSide::DuCrossDv, ToolSide::DvCrossDu}) {
        const std::vector<Surface> surfaces{
            test::polynomial_surface({test::monomial(1, 0, 1), test::monomial(0, 1, 1),
                                      test::monomial(2, 0, 0.02)},
                                     {{-10, 10}, {0, 10}}, {1, 1}, side)};
        const double up = side == ToolSide::DuCrossDv ? 1 : -1;
        const SampledSurface found = sampled_up(surfaces, 0.05);
        for (std::size_t k = 0; k < found.normals.size(); ++k) {
            const double slope = 0.04 * found.mesh.points()[k].x();
            const Vec3 expected = up * Vec3{-slope, 0, 1}.normalized();
            EXPECT_LT((found.normals[k] - expected).norm(), 1e-12);
        }
        for (std::size_t t = 0; t < found.mesh.triangles().size(); ++t) {
            const auto [a, b, c] = found.mesh.corners(t);
            EXPECT_GT(up * (b - a).cross(c - a).z(), 0);
        }
    }
}

TEST(Sampling, AtAPoleHasOnePointWithItsNormal)
{
    const SampledSurface found =
        sampled_up({nurbs_surface(test::torus(0, 9, {0, pi / 2, 0.3, pi / 2, 2}))}, 0.05);
    int poles = 0;
    for (std::size_t k = 0; k < found.normals.size(); ++k) {
        const Vec3& point = found.mesh.points()[k];
        EXPECT_LT((found.normals[k] - point / 9).norm(), 1e-9);
        if ((point - Vec3{0, 0, 9}).norm() < 1e-6)
            ++poles;
    }
    EXPECT_EQ(poles, 1);
    EXPECT_EQ(mesh_report(found.mesh).degenerate_triangles, 0U);
}

TEST(Sampling, OfAClosedSurfaceIsClosed)
{
    const std::vector<Surface> ball{
        nurbs_surface(test::torus(20, 7, {0, 2 * pi, 0, 2 * pi, 4}))};
    const SampledSurface found = sampled(ball, std::vector<double>{1}, 0.02);
    const MeshReport report = mesh_report(found.mesh);
    EXPECT_EQ(report.boundary_edges, 0U);
    ASSERT_TRUE(report.volume);
    const double expected = 2 * pi * pi * 20 * 49;
    EXPECT_NEAR(*report.volume, expected, 0.01 * expected);
}

TEST(Sampling, PatchesThatShareTheirBordersShareItsPoints)
{
    const Surface whole = test::random_surface(5, {3, 3}, 6);
    std::vector<Surface> apart;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            Surface part{{0, 1}, {0, 1}, {whole.patch(i, j)}};
            apart.push_back((i + j) % 2 == 0 ? part : reversed_in_u(part));
        }
    const SampledSurface found = sampled_up(apart, 0.05);
    const MeshReport report = mesh_report(found.mesh);
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.inconsistent_edges, 0U);
    const double faces = double(found.mesh.triangles().size());
    const double edges = (3 * faces + double(report.boundary_edges)) / 2;
    EXPECT_EQ(double(found.mesh.points().size()) - edges + faces, 1);
}

TEST(Sampling, LeavesAGapWhereTheSurfaceHasOne)
{
    const SplineParameter parted{2, {0, 0, 0, 1, 1, 1, 2, 2, 2}};
    const SplineParameter whole{1, {0, 0, 1, 1}};
    Nurbs nurbs{parted, whole, {}, {}};
    for (const double y : {0.0, 10.0})
        for (const double x : {0.0, 5.0, 10.0, 12.0, 17.0, 22.0})
            nurbs.control_points.emplace_back(x, y, x > 11 ? 4 : 0);
    const SampledSurface found = sampled_up({nurbs_surface(nurbs)}, 0.1);
    const MeshReport report = mesh_report(found.mesh);
    EXPECT_EQ(report.components, 2U);
    EXPECT_NEAR(report.area, 200, 1e-9);
}

TEST(Sampling, OnAGridHasItsPlacesAndMeasuresItsError)
{
    const std::vector<Surface> trough{test::parabolic_cylinder(0.04, 20, 30, {3, 1})};
    const SampledSurface found =
        sampled_on_grid(trough, tool_side_signs(trough, Vec3::UnitZ()), 11);
    EXPECT_EQ(found.mesh.points().size(), 121U);
    EXPECT_EQ(found.mesh.triangles().size(), 200U);
    // the sagitta bend w^2 / 8 of a cell 4 mm wide, which is measured at eighths
    const double sagitta = 0.04 * 16 / 8;
    EXPECT_LE(found.max_chord_error_mm, sagitta + 1e-12);
    EXPECT_GE(found.max_chord_error_mm, 0.9 * sagitta);
}

TEST(Sampling, OfALineIsRefused)
{
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const std::vector<Surface> surfaces{
        Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, {line.data(), 4}}}}};
    const SampledSurface flat = sampled_up(surfaces, 0.1);
    EXPECT_EQ(mesh_report(flat.mesh).area, 0) << "folded on itself";
    const std::vector<Vec3> collapsed{{0, 0, 0}, {3, 0, 0}, {0, 0, 0}, {3, 0, 0}};
    const std::vector<Surface> line_only{
        Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, {collapsed.data(), 4}}}}};
    EXPECT_THROW(sampled_up(line_only, 0.1), GeometryError);
}

TEST(Sampling, RefusesInvalidArguments)
{
    const std::vector<Surface> plane{test::plane(10, 10)};
    const std::vector<double> up{1};
    EXPECT_THROW(sampled(plane, up, 0), DomainError);
    EXPECT_THROW(sampled(plane, up, NAN), DomainError);
    EXPECT_THROW(sampled_on_grid(plane, up, 1), DomainError);
    EXPECT_THROW(sampled_on_grid(plane, up, 100, 1000), LimitError);
    const std::vector<Surface> bent{test::saddle(20, 10)};
    EXPECT_THROW(sampled(bent, up, 1e-4, 1000), LimitError);
    EXPECT_THROW(sampled(bent, up, 1e-300), LimitError);
}

TEST(Sampling, AtTheApexOfAConeHasTheMeanOfItsTriangles)
{
    const test::UnitArc arc = test::unit_arc(0, 2 * pi, 4);
    Nurbs cone{{2, arc.knots}, {1, {0, 0, 1, 1}}, {}, {}};
    for (const double radius : {10.0, 0.0})
        for (std::size_t i = 0; i < arc.points.size(); ++i) {
            cone.control_points.emplace_back(radius * arc.points[i].x(),
                                             radius * arc.points[i].y(), 10 - radius);
            cone.weights.push_back(arc.weights[i]);
        }
    const SampledSurface found = sampled_up({nurbs_surface(cone)}, 0.05);
    int apexes = 0;
    for (std::size_t k = 0; k < found.normals.size(); ++k)
        if (found.mesh.points()[k].z() > 10 - 1e-6) {
            ++apexes;
            EXPECT_LT((found.normals[k] - Vec3::UnitZ()).norm(), 1e-6);
        }
    EXPECT_EQ(apexes, 1);
}

TEST(Sampling, FarFromTheOriginIsTheSameMesh)
{
    const double top = pi / 2;
    const TriangleMesh near =
        sampled_up({nurbs_surface(test::torus(0, 9, {0, top, 0.3, top}))}, 0.05).mesh;
    Nurbs cap = test::torus(0, 9, {0, top, 0.3, top});
    for (Vec3& point : cap.control_points)
        point += Vec3{4e5, -3e5, 2e5};
    const TriangleMesh far = sampled_up({nurbs_surface(cap)}, 0.05).mesh;
    EXPECT_EQ(far.triangles().size(), near.triangles().size());
    EXPECT_EQ(far.points().size(), near.points().size());
}

TEST(DefaultChordTolerance, IsAThousandthOfTheLongestSideToADigit)
{
    const auto of_length = [](double length) {
        return default_chord_tolerance(std::vector{test::plane(length, 1)});
    };
    EXPECT_NEAR(of_length(60), 0.06, 1e-12);
    EXPECT_NEAR(of_length(300), 0.3, 1e-12);
    EXPECT_NEAR(of_length(10 - 1e-15), 0.01, 1e-12);
    EXPECT_NEAR(of_length(123), 0.1, 1e-12);
}

}  // namespace
}  // namespace endmill
