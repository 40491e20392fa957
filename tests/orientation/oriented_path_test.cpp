// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/oriented_path.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"
#include "test_meshes.h"

namespace endmill {
namespace {

// The surface z = (a x^2 + b y^2) / 2 over [-15, 15] x [-10, 10], exact as a patch of degree 2.
std::vector<Surface> paraboloid(double a, double b)
{
    const double x = 15;
    const double y = 10;
    std::vector<Vec3> net;
    for (const double j : {-1.0, 0.0, 1.0})
        for (const double i : {-1.0, 0.0, 1.0})
            // the blossom of x^2 at (-1, 1) is -1
            net.emplace_back(
                i * x, j * y,
                (a * x * x * (i == 0 ? -1 : 1) + b * y * y * (j == 0 ? -1 : 1)) / 2);
    return {Surface{{0, 1}, {0, 1}, {BezierPatch{2, 2, net}}}};
}

OrientedOptions options_of(AxisMode mode, double lead_deg)
{
    OrientedOptions options;
    options.mode = mode;
    options.inclination.lead = Angle::degrees(lead_deg);
    options.scallop_height = 0.05;
    options.inner_tolerance = 0.01;
    options.safe_height = 20;
    return options;
}

// The least signed distance of a point from the cutter on all cuts, by dense sampling.
double least_distance(const ToolPath& path, const Cutter& cutter, const Vec3& point)
{
    const CuttingBody body{cutter};
    double least = 1e9;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        if (path.points[k].move != Move::Cut)
            continue;
        const ToolMotion motion{path.points[k - 1].location, path.points[k].location};
        const double way = (motion.to().tip - motion.from().tip).norm();
        const int parts = 10 + static_cast<int>(20 * way);
        for (int part = 0; part <= parts; ++part)
            least = std::min(
                least,
                body.distance(motion.seen(point, static_cast<double>(part) / parts))
                    .value);
    }
    return least;
}

TEST(PlanOriented, OnAPlaneHasTheStripsOfTheInclinedCircle)
{
    const OrientedOptions options = options_of(AxisMode::Fixed, 10);
    const OrientedPath plan = plan_oriented(paraboloid(0, 0), Cutter::flat(5), options);
    const double strip =
        2 * std::sqrt(2 * 0.05 * 5 / std::sin(Angle::degrees(10).radians()));
    EXPECT_NEAR(plan.narrowest_strip_mm, strip, 1e-9);
    EXPECT_EQ(plan.passes, std::ceil(20 / (0.97 * strip)));
    EXPECT_NEAR(plan.cut_contact_mm, 30 * static_cast<double>(plan.passes), 1e-9);
    EXPECT_NEAR(plan.lead.least.degrees(), 10, 1e-12);
    EXPECT_NEAR(plan.lead.greatest.degrees(), 10, 1e-12);
    for (const PathPoint& point : plan.path.points)
        EXPECT_NEAR(point.location.axis.z(), std::cos(Angle::degrees(10).radians()),
                    1e-12);
}

// No part of the surface is deeper in the cutter than the tolerance, and every place is cut to
// the height, by a computation of its own at places between the passes.
TEST(PlanJudgedOriented, IsCleanOnSaddlesAndBowls)
{
    struct Case {
        double a;
        double b;
        Cutter cutter;
    };
    for (const auto& [a, b, cutter] :
         {Case{0.015, -0.03, Cutter{5, 1}}, Case{0.02, 0.015, Cutter{5, 1}},
          Case{0.02, -0.03, Cutter::ball(5)}}) {
        const OrientedOptions options = options_of(AxisMode::Lead, 5);
        const auto part = paraboloid(a, b);
        const JudgedOrientedPath judged = plan_judged_oriented(part, cutter, options);
        EXPECT_EQ(judged.verification.verdict, Verdict::Clean);
        EXPECT_LE(judged.verification.on_part->deviation.max_gouge_mm, 0.01);
        EXPECT_LE(judged.verification.on_part->deviation.max_scallop_mm, 0.05);
        for (double u = 0.03; u < 1; u += 0.13)
            for (double v = 0.02; v < 1; v += 0.11) {
                const SurfaceTangents at = part[0].tangents(u, v);
                const Vec3 normal = unit_normal(at);
                const ToolPath& path = judged.plan.path;
                EXPECT_GE(least_distance(path, cutter, at.point), -0.01 - 1e-9);
                EXPECT_LE(least_distance(path, cutter, at.point + 0.05 * normal), 1e-3);
            }
    }
}

// A tilted cutter touches ahead of the contact on one side of a pass, and behind it on the other.
// The ends of all passes are cut to the height nevertheless.
TEST(PlanJudgedOriented, CutsTheEndsOfPassesWithATilt)
{
    const Cutter cutter{5, 1};
    const auto plane = paraboloid(0, 0);
    for (const double tilt : {-8.0, 8.0}) {
        OrientedOptions options = options_of(AxisMode::Fixed, 10);
        options.inclination.tilt = Angle::degrees(tilt);
        const JudgedOrientedPath judged = plan_judged_oriented(plane, cutter, options);
        EXPECT_EQ(judged.verification.verdict, Verdict::Clean);
        for (const double u : {0.0, 1.0})
            for (double v = 0; v <= 1; v += 0.05) {
                const Vec3 top = plane[0].tangents(u, v).point + Vec3{0, 0, 0.05};
                EXPECT_LE(least_distance(judged.plan.path, cutter, top), 1e-3) << v;
            }
    }
}

TEST(PlanOriented, TakesTheLeadThatTheBowlNeeds)
{
    const auto bowl = paraboloid(0.03, 0.03);
    const OrientedPath plan =
        plan_oriented(bowl, Cutter{5, 1}, options_of(AxisMode::Lead, 0));
    // the greatest concave curvature is 0.03, at the middle
    const double heel = std::asin(4 / (1 / 0.03 - 1)) * 180 / std::acos(-1.0);
    EXPECT_NEAR(plan.lead.least.degrees(), heel + 1, 0.01);
}

TEST(PlanOriented, RefusesACutterThatDoesNotFitAndNamesTheLead)
{
    const auto bowl = paraboloid(0.03, 0.03);
    try {
        plan_oriented(bowl, Cutter{5, 1}, options_of(AxisMode::Fixed, 1));
        FAIL();
    } catch (const GeometryError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("does not fit at u = "), std::string::npos) << message;
        EXPECT_NE(message.find("the least lead there is "), std::string::npos) << message;
    }
    EXPECT_THROW(plan_oriented(paraboloid(0.3, 0.3), Cutter::flat(5),
                               options_of(AxisMode::Lead, 1)),
                 GeometryError);
    OrientedOptions wrong = options_of(AxisMode::Lead, 1);
    wrong.scallop_height = 0;
    EXPECT_THROW(plan_oriented(bowl, Cutter{5, 1}, wrong), DomainError);
    wrong = options_of(AxisMode::Lead, 1);
    wrong.most_points = 10;
    EXPECT_THROW(plan_oriented(bowl, Cutter{5, 1}, wrong), LimitError);
    EXPECT_THROW(plan_oriented(std::vector<Surface>{}, Cutter{5, 1}, wrong), DomainError);
}

// The turns of the axis over all moves, added up here.
double travel_deg(const ToolPath& path)
{
    double sum = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k)
        sum +=
            angle_between(path.points[k - 1].location.axis, path.points[k].location.axis);
    return Angle::radians(sum).degrees();
}

// On a dome whose normals turn by 34 degrees along x an axis within 30 degrees of the normals
// need not turn at all.
TEST(PlanOriented, AFieldOnADomeTurnsLessThanTheLead)
{
    const auto dome = paraboloid(-0.02, -0.01);
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 1}}) {
        const OrientedPath lead =
            plan_oriented(dome, cutter, options_of(AxisMode::Lead, 5));
        const OrientedPath field =
            plan_oriented(dome, cutter, options_of(AxisMode::Field, 5));
        EXPECT_NEAR(travel_deg(lead.path), lead.rotary_travel.degrees(), 1e-9);
        EXPECT_NEAR(travel_deg(field.path), field.rotary_travel.degrees(), 1e-9);
        EXPECT_LT(travel_deg(field.path),
                  (cutter.is_ball() ? 0.2 : 1) * travel_deg(lead.path));
        EXPECT_EQ(field.passes, lead.passes);
        EXPECT_GE(field.lead.least.degrees(), -30 - 1e-6);
        EXPECT_LE(field.lead.greatest.degrees(), 30 + 1e-6);
        EXPECT_GE(field.narrowest_strip_mm, 0.9 * lead.narrowest_strip_mm);
        ASSERT_TRUE(field.least_gap_mm);
        EXPECT_GE(*field.least_gap_mm, -0.01);
        EXPECT_FALSE(lead.least_gap_mm);
    }
}

TEST(PlanJudgedOriented, IsCleanWithAField)
{
    for (const auto& [part, cutter] :
         {std::pair{paraboloid(0.015, -0.03), Cutter::ball(5)},
          std::pair{paraboloid(-0.02, -0.01), Cutter{5, 1}}}) {
        const JudgedOrientedPath judged =
            plan_judged_oriented(part, cutter, options_of(AxisMode::Field, 5));
        EXPECT_EQ(judged.verification.verdict, Verdict::Clean);
    }
}

TEST(PlanOriented, AFieldIsTheSameWithAnyNumberOfThreads)
{
    const auto saddle = paraboloid(0.015, -0.03);
    ToolPath first;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        const ToolPath path =
            plan_oriented(saddle, Cutter::ball(5), options_of(AxisMode::Field, 0)).path;
        if (first.points.empty())
            first = path;
        ASSERT_EQ(path.points.size(), first.points.size());
        for (std::size_t k = 0; k < path.points.size(); ++k) {
            EXPECT_EQ(path.points[k].location.tip, first.points[k].location.tip);
            EXPECT_EQ(path.points[k].location.axis, first.points[k].location.axis);
        }
    }
}

TEST(PlanOriented, AFieldWithoutAxesNamesPlaceAndRule)
{
    const auto bowl = paraboloid(0.03, 0.03);
    OrientedOptions options = options_of(AxisMode::Field, 0);
    options.field.lead = {Angle::degrees(-20), Angle::degrees(2)};
    try {
        plan_oriented(bowl, Cutter{5, 1}, options);
        FAIL();
    } catch (const GeometryError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("no tool axis is allowed at contact 0"), std::string::npos)
            << message;
        EXPECT_NE(message.find("the lead that keeps the heel off"), std::string::npos)
            << message;
    }
    // a holder that is wider than the bowl and lower than its rim
    options.field = {};
    options.tool_body = {{200, 3, 60}};
    try {
        plan_oriented(bowl, Cutter::ball(5), options);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("the gap of shank or holder"),
                  std::string::npos)
            << error.what();
    }
}

// The graph z = (a x^2 + b y^2) / 2 over [-15, 15] x [-10, 10] as a mesh with cells of 30 / `cells`
// mm. Its points are on the surface of `paraboloid`.
TriangleMesh graph(double a, double b, int cells = 90)
{
    const int rows = 2 * cells / 3;
    return test::grid_mesh(cells, rows, [&](int i, int j) {
        const double x = 30.0 * i / cells - 15;
        const double y = 20.0 * j / rows - 10;
        return Vec3{x, y, (a * x * x + b * y * y) / 2};
    });
}

OrientedOptions planar_options(AxisMode mode, double lead_deg)
{
    OrientedOptions options = options_of(mode, lead_deg);
    options.mesh_passes.strategy = Strategy::Planar;
    options.mesh_passes.direction = Angle::degrees(0);
    return options;
}

// On a mesh the ball touches the surface that the mesh approximates, and its axis is the normal of
// that surface, within the errors of the mesh.
TEST(PlanOrientedOnAMesh, LeansAgainstTheNormalsOfTheSurface)
{
    const double a = -0.02;
    const double b = -0.01;
    const OrientedPath plan =
        plan_oriented(graph(a, b), Cutter::ball(5), planar_options(AxisMode::Lead, 0));
    std::size_t contacts = 0;
    for (const PathPoint& point : plan.path.points) {
        const SurfaceContact* at = point.contact();
        if (!at)
            continue;
        const Vec3& place = at->contact.point;
        const Vec3 normal = Vec3{-a * place.x(), -b * place.y(), 1}.normalized();
        // chords of moves are within the inner tolerance
        EXPECT_NEAR(place.z(),
                    (a * place.x() * place.x() + b * place.y() * place.y()) / 2, 0.012);
        EXPECT_NEAR((point.location.axis - at->contact.normal).norm(), 0, 1e-9);
        // a border is rounded by the ball, whose normals lean outwards there
        if (std::abs(place.x()) < 14.9 && std::abs(place.y()) < 9.9) {
            EXPECT_NEAR((at->contact.normal - normal).norm(), 0, 0.01);
        }
        ++contacts;
    }
    EXPECT_GT(contacts, 100U);
    EXPECT_GT(plan.cut_contact_mm, 30.0 * 10);
}

// Ball and bull-nose cutter cut meshes of smooth parts clean, with leads and with fields.
TEST(PlanOrientedOnAMesh, IsCleanOnDomesAndSaddles)
{
    for (const auto& [a, b] : {std::pair{-0.02, -0.01}, std::pair{0.015, -0.03}})
        for (const AxisMode mode : {AxisMode::Lead, AxisMode::Field}) {
            OrientedOptions options = planar_options(mode, 5);
            options.inner_tolerance = 0.02;
            options.scallop_height = 0.1;
            const JudgedOrientedPath judged =
                plan_judged_oriented(graph(a, b), Cutter::ball(5), options);
            EXPECT_EQ(judged.verification.verdict, Verdict::Clean);
        }
    OrientedOptions options = planar_options(AxisMode::Lead, 5);
    options.inner_tolerance = 0.03;
    options.scallop_height = 0.1;
    EXPECT_EQ(plan_judged_oriented(graph(-0.02, -0.01), Cutter{5, 1}, options)
                  .verification.verdict,
              Verdict::Clean);
}

// The field of a mesh keeps its ranges and gap, and turns about as much as that of the surface:
// on this dome neither has to turn much.
TEST(PlanOrientedOnAMesh, AFieldTurnsLittleOnADome)
{
    const OrientedPath lead = plan_oriented(graph(-0.02, -0.01), Cutter::ball(5),
                                            planar_options(AxisMode::Lead, 0));
    const OrientedPath field = plan_oriented(graph(-0.02, -0.01), Cutter::ball(5),
                                             planar_options(AxisMode::Field, 0));
    EXPECT_EQ(field.passes, lead.passes);
    EXPECT_LT(travel_deg(field.path), 0.2 * travel_deg(lead.path));
    EXPECT_GE(field.lead.least.degrees(), -30 - 1e-6);
    EXPECT_LE(field.tilt.greatest.degrees(), 30 + 1e-6);
    ASSERT_TRUE(field.least_gap_mm);
    EXPECT_GE(*field.least_gap_mm, -0.01);
}

TEST(PlanOrientedOnAMesh, IsTheSameWithAnyNumberOfThreads)
{
    const TriangleMesh saddle = graph(0.015, -0.03, 45);
    ToolPath first;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        const ToolPath path =
            plan_oriented(saddle, Cutter{5, 1}, planar_options(AxisMode::Field, 0)).path;
        if (first.points.empty())
            first = path;
        ASSERT_EQ(path.points.size(), first.points.size());
        for (std::size_t k = 0; k < path.points.size(); ++k) {
            EXPECT_EQ(path.points[k].location.tip, first.points[k].location.tip);
            EXPECT_EQ(path.points[k].location.axis, first.points[k].location.axis);
        }
    }
}

TEST(PlanOrientedOnAMesh, RefusesTrianglesThatFaceOppositeSides)
{
    const TriangleMesh mesh = test::with_turned(
        graph(-0.02, -0.01, 9), [](std::size_t number) { return number == 40; });
    try {
        plan_oriented(mesh, Cutter::ball(5), planar_options(AxisMode::Lead, 0));
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("at 3 edges of the mesh"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_THROW(
        plan_oriented(TriangleMesh{}, Cutter::ball(5), planar_options(AxisMode::Lead, 0)),
        DomainError);
}

// Facets of 5 mm on a radius of 50 mm are 0.06 mm below the surface: a flat cutter that leans
// against the normals of the surface gouges them.
TEST(PlanOrientedOnAMesh, RefusesAWideCutterOnACoarseMeshThatItGouges)
{
    OrientedOptions options = planar_options(AxisMode::Lead, 0);
    options.inner_tolerance = 0.01;
    options.scallop_height = 0.1;
    try {
        plan_judged_oriented(graph(-0.05, -0.05, 6), Cutter{5, 0}, options);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("expected a finer mesh"),
                  std::string::npos)
            << error.what();
    }
}

// A ball of radius R stays R / cos(a) - R above the bottom of a valley whose sides rise by the angle
// a. Closer passes do not lower that.
TEST(PlanOrientedOnAMesh, EndsWithTheStockThatIsBeyondReach)
{
    const double slope = 0.5;
    const TriangleMesh valley = test::grid_mesh(20, 20, [&](int i, int j) {
        return Vec3{double(i - 10), double(j - 10), slope * std::abs(i - 10)};
    });
    OrientedOptions options = planar_options(AxisMode::Lead, 0);
    options.scallop_height = 0.2;
    options.inner_tolerance = 0.05;
    options.safe_height = 20;
    const JudgedOrientedPath judged =
        plan_judged_oriented(valley, Cutter::ball(3), options);
    EXPECT_EQ(judged.verification.verdict, Verdict::Uncut);
    const double left = judged.verification.on_part->deviation.max_scallop_mm;
    const double beyond_reach = 3 * std::hypot(1, slope) - 3;
    EXPECT_GT(left, beyond_reach - 0.01);
    // between two passes a scallop is above the bottom too
    EXPECT_LT(left, beyond_reach + options.scallop_height);
}

}  // namespace
}  // namespace endmill
