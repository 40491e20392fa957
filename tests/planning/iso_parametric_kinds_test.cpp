// SPDX-License-Identifier: GPL-3.0-or-later
// The planner on every kind of surface: closed forms, and one surface in several
// representations.
#include "endmill/planning/iso_parametric.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "elevated.h"
#include "endmill/surface/nurbs.h"
#include "planned_path.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

struct CrossSection {
    double rho;   // radius of curvature, mm; positive where convex
    double ball;  // radius of the ball, mm
    double h;     // scallop, mm
};

// Angle in rad between neighbouring contacts at the centre of the section, from the law
// of cosines in the triangle of that centre, a ball's centre and the scallop's peak.
double angle_between_passes(const CrossSection& s)
{
    const double a = s.rho + s.ball;
    const double b = s.rho + s.h;
    return 2 * std::acos((a * a + b * b - s.ball * s.ball) / (2 * a * b));
}

// Two balls touch the circle of radius rho about the origin at the angles +-half. Returns
// the height above the circle at which they meet, on the bisector.
double cusp_left(const CrossSection& s, double half)
{
    const double x = (s.rho + s.ball) * std::sin(half);
    const double y = (s.rho + s.ball) * std::cos(half);
    const double down = std::sqrt(s.ball * s.ball - x * x);
    return s.rho > 0 ? y - down - s.rho : -s.rho - (std::abs(y) + down);
}

// The angle about (y, z) = (0, 0) of each pass; `angle_of` returns that of a contact.
template <class AngleOf>
std::vector<double> pass_angles(const ToolPath& path, const AngleOf& angle_of)
{
    std::vector<double> angles;
    for (const auto& pass : test::passes_of(path))
        angles.push_back(angle_of(test::contact_point(pass.front())));
    return angles;
}

void expect_spacing(const std::vector<double>& angles, const CrossSection& section)
{
    const double expected = angle_between_passes(section);
    ASSERT_GT(angles.size(), 4U);
    for (std::size_t k = 1; k + 1 < angles.size(); ++k) {
        const double apart = std::abs(angles[k] - angles[k - 1]);
        EXPECT_NEAR(apart, expected, 1e-9 * expected);
        EXPECT_NEAR(cusp_left(section, apart / 2), section.h, 1e-9);
    }
    EXPECT_LE(std::abs(angles.back() - angles[angles.size() - 2]), expected * (1 + 1e-9))
        << "the last pass stands on the border";
}

IsoParametricOptions options_of(const CrossSection& section)
{
    IsoParametricOptions options;
    options.scallop_height = section.h;
    options.chord_tolerance = 0.02;
    return options;
}

TEST(PlannedKinds, PassesAlongAConvexCylinderAreEquallySpaced)
{
    const CrossSection section{20, 6, 0.05};
    const Surface surface = nurbs_surface(test::cylinder(20, 60, 0.3, pi - 0.3, 2));
    const auto plan =
        plan_iso_parametric(surface, BallCutter{section.ball}, options_of(section));
    expect_spacing(
        pass_angles(plan.path, [](const Vec3& p) { return std::atan2(p.z(), p.y()); }),
        section);
    for (const auto& pass : test::passes_of(plan.path))
        EXPECT_EQ(pass.size(), 2U) << "a straight line has two points";
}

TEST(PlannedKinds, PassesAlongAConcaveCylinderAreEquallySpaced)
{
    const CrossSection section{-20, 6, 0.05};
    const Surface surface =
        nurbs_surface(test::cylinder(20, 60, pi + 0.4, 2 * pi - 0.4, 2));
    const auto plan =
        plan_iso_parametric(surface, BallCutter{section.ball}, options_of(section));
    std::vector<double> angles =
        pass_angles(plan.path, [](const Vec3& p) { return std::atan2(p.z(), p.y()); });
    expect_spacing(angles, section);
}

TEST(PlannedKinds, PassesAroundASphereAreEquallySpaced)
{
    const CrossSection section{25, 8, 0.1};
    const Surface surface =
        nurbs_surface(test::torus(0, section.rho, {0, 1.2, 0.3, 1.4, 2}));
    const auto plan =
        plan_iso_parametric(surface, BallCutter{section.ball}, options_of(section));
    expect_spacing(pass_angles(plan.path,
                               [](const Vec3& p) {
                                   return std::atan2(p.z(), std::hypot(p.x(), p.y()));
                               }),
                   section);
}

TEST(PlannedKinds, PassesAroundATorusAreEquallySpacedOnItsTube)
{
    const CrossSection section{15, 5, 0.05};
    const Surface surface =
        nurbs_surface(test::torus(40, section.rho, {0, 1, 0.4, pi - 0.5, 3}));
    const auto plan =
        plan_iso_parametric(surface, BallCutter{section.ball}, options_of(section));
    expect_spacing(pass_angles(plan.path,
                               [](const Vec3& p) {
                                   const double rho = std::hypot(p.x(), p.y());
                                   return std::atan2(p.z(), rho - 40);
                               }),
                   section);
}

TEST(PlannedKinds, PassesOnASphereEndInItsPoleAsAPoint)
{
    const CrossSection section{25, 8, 0.1};
    const Surface surface =
        nurbs_surface(test::torus(0, section.rho, {0, 1.2, 0.4, pi / 2, 2}));
    const auto plan =
        plan_iso_parametric(surface, BallCutter{section.ball}, options_of(section));
    const auto passes = test::passes_of(plan.path);
    ASSERT_EQ(passes.back().size(), 1U);
    EXPECT_LT((test::contact_point(passes.back().front()) - Vec3{0, 0, 25}).norm(),
              1e-12);
    EXPECT_LT((passes.back().front().contact()->contact.normal - Vec3::UnitZ()).norm(),
              1e-9);
    expect_spacing(pass_angles(plan.path,
                               [](const Vec3& p) {
                                   return std::atan2(p.z(), std::hypot(p.x(), p.y()));
                               }),
                   section);
}

// Each step around a cylinder of radius r turns by 2 acos(1 - delta / r).
TEST(PlannedKinds, StepsAroundACylinderKeepTheChordTolerance)
{
    const double r = 20;
    const Surface surface = nurbs_surface(test::cylinder(r, 30, 0.3, pi - 0.3, 3));
    IsoParametricOptions options;
    options.direction = Parameter::V;
    options.chord_tolerance = 0.05;
    const auto plan = plan_iso_parametric(surface, BallCutter{5}, options);
    const double expected = 2 * std::acos(1 - options.chord_tolerance / r);
    const auto passes = test::passes_of(plan.path);
    for (std::size_t n = 0; n < passes.size(); ++n) {
        const auto& pass = passes[n];
        const std::size_t turned = n % 2;  // the remainder comes last, or first
        for (std::size_t k = 1 + turned; k + 1 < pass.size() + turned; ++k) {
            const Vec3& before = test::contact_point(pass[k - 1]);
            const Vec3& after = test::contact_point(pass[k]);
            const double turn = std::abs(std::atan2(after.z(), after.y()) -
                                         std::atan2(before.z(), before.y()));
            EXPECT_NEAR(turn, expected, 1e-9 * expected);
        }
    }
}

// z is a bicubic polynomial over [0, 60] by [0, 40].
Surface bicubic_graph(test::PatchCounts patches)
{
    test::Polynomial height = test::Polynomial::Zero();
    height(2, 0) = 0.004;
    height(1, 1) = 0.003;
    height(0, 2) = -0.005;
    height(3, 0) = -3e-5;
    height(2, 3) = 2e-7;
    return test::graph(height, {{0, 60}, {0, 40}}, patches);
}

Surface with_patches(const Surface& surface,
                     const std::function<BezierPatch(const BezierPatch&)>& changed)
{
    std::vector<BezierPatch> patches;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i)
            patches.push_back(changed(surface.patch(i, j)));
    const auto u = surface.breaks(Parameter::U);
    const auto v = surface.breaks(Parameter::V);
    return Surface{{u.begin(), u.end()}, {v.begin(), v.end()}, patches};
}

Surface as_height_grid(const Surface& graph)
{
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    for (int k = 0; k <= 6; ++k)
        x.push_back(10 * k);
    for (int k = 0; k <= 5; ++k)
        y.push_back(8 * k);
    for (const double b : y)
        for (const double a : x)
            z.push_back(graph.tangents(a / 60, b / 40).point.z());
    return height_grid(x, y, z);
}

Surface as_nurbs(const Surface& patch)
{
    Nurbs nurbs{{3, {2, 2, 2, 2, 7, 7, 7, 7}}, {3, {0, 0, 0, 0, 1, 1, 1, 1}}, {}, {}};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            nurbs.control_points.push_back(patch.patch(0, 0).control_point(i, j));
            nurbs.weights.push_back(3.5);
        }
    return nurbs_surface(nurbs);
}

void expect_same_path(const ToolPath& path, const ToolPath& expected)
{
    ASSERT_EQ(path.points.size(), expected.points.size());
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& a = path.points[k];
        const PathPoint& b = expected.points[k];
        EXPECT_EQ(a.pass, b.pass);
        EXPECT_EQ(a.move, b.move);
        EXPECT_LT((a.location.tip - b.location.tip).norm(), 1e-9);
        EXPECT_LT((test::contact_point(a) - test::contact_point(b)).norm(), 1e-9);
        EXPECT_LT((a.contact()->contact.normal - b.contact()->contact.normal).norm(),
                  1e-9);
    }
}

TEST(PlannedKinds, OneSurfaceHasTheSamePathInEveryKind)
{
    const Surface bezier = bicubic_graph({1, 1});
    const auto higher = [](const BezierPatch& patch) {
        return test::elevated(patch, 5, 4);
    };
    const Surface kinds[] = {as_nurbs(bezier), as_height_grid(bezier),
                             with_patches(bezier, higher), bicubic_graph({3, 2})};
    for (const Parameter direction : {Parameter::U, Parameter::V}) {
        IsoParametricOptions options;
        options.direction = direction;
        options.chord_tolerance = 0.05;
        options.scallop_height = 0.05;
        const ToolPath expected =
            plan_iso_parametric(bezier, BallCutter{6}, options).path;
        for (const Surface& surface : kinds)
            expect_same_path(plan_iso_parametric(surface, BallCutter{6}, options).path,
                             expected);
    }
}

TEST(PlannedKinds, SeveralSurfacesArePlannedOneAfterTheOther)
{
    const Surface whole = bicubic_graph({2, 1});
    const std::vector<Surface> apart{Surface{{0, 1}, {0, 1}, {whole.patch(0, 0)}},
                                     Surface{{0, 1}, {0, 1}, {whole.patch(1, 0)}}};
    IsoParametricOptions options;
    options.link.safe_height = 100;
    const IsoParametricPlan plan = plan_iso_parametric(apart, BallCutter{6}, options);
    std::size_t points = 2;  // the lift between them
    std::size_t passes = 0;
    for (const Surface& surface : apart) {
        const IsoParametricPlan own =
            plan_iso_parametric(surface, BallCutter{6}, options);
        points += own.path.points.size();
        passes += own.governing.size();
    }
    EXPECT_EQ(plan.path.points.size(), points);
    EXPECT_EQ(plan.governing.size(), passes);
    EXPECT_EQ(plan.path.points.back().patch, 1);
}

}  // namespace
}  // namespace endmill
