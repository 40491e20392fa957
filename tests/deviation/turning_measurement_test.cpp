// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/turning_measurement.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "turning_paths.h"

namespace endmill {
namespace {

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

// All motions of a path, in the region of a large ball.
ToolPieces pieces_of(const ToolPath& path, const CuttingBody& body)
{
    std::vector<ToolPiece> pieces;
    for (std::size_t k = 1; k < path.points.size(); ++k)
        pieces.push_back({{path.points[k - 1].location, path.points[k].location},
                          body,
                          static_cast<std::int32_t>(k),
                          static_cast<std::int32_t>(k)});
    return {std::move(pieces), {{0, 0, 0}, 200}};
}

DeviationOptions options_of(double tolerance, double scallop, double pitch)
{
    DeviationOptions options;
    options.limits = {tolerance, scallop};
    options.pitch = pitch;
    return options;
}

// Measures a path that starts from much material over the part.
Deviation measured(const Part& part, const ToolPath& path, const CuttingBody& body,
                   const DeviationOptions& options)
{
    const ToolPieces pieces = pieces_of(path, body);
    const TurnedStock stock{pieces, [](const PartRay&) { return CutRay{30, 0, -1}; }};
    return measure_turning_deviation(part_charts(part), stock, options).deviation;
}

// A part of the plane z = 0 below the passes of `plane_passes`.
Part plane_below(double low_x, double high_x, double half_y)
{
    const Nurbs plane{{1, {0, 0, 1, 1}},
                      {1, {0, 0, 1, 1}},
                      {{low_x, -half_y, 0},
                       {high_x, -half_y, 0},
                       {low_x, half_y, 0},
                       {high_x, half_y, 0}},
                      {}};
    return std::vector<Surface>{nurbs_surface(plane)};
}

void expect_scallop(const Deviation& found, double expected)
{
    EXPECT_LE(found.max_scallop_mm, expected + 1e-6);
    EXPECT_GE(found.max_scallop_mm + found.scallop_bound_mm, expected - 1e-6);
}

class ScallopOnADome : public testing::TestWithParam<std::pair<double, double>> {};

// Rings by turning the part: the ball leaves the same scallops with any lead.
TEST_P(ScallopOnADome, IsThatOfTheClosedForm)
{
    const auto [step_deg, lead_deg] = GetParam();
    const double step = rad(step_deg);
    const Cutter ball = Cutter::ball(5);
    const double half = step / 2;
    const double exact =
        25 * std::cos(half) - std::sqrt(25 - 625 * std::sin(half) * std::sin(half)) - 20;
    const ToolPath path =
        test::dome_rings(ball, {.radius = 20,
                                .step = step,
                                .polar = {rad(30) - 2 * step, rad(30) + 3 * step},
                                .azimuth = {-0.4, 0.6},
                                .lead = rad(lead_deg)});
    const Part part = test::dome(20, {rad(30) - step / 4, rad(30) + step}, 0.2);
    const Deviation found =
        measured(part, path, CuttingBody{ball}, options_of(0.01, exact + 0.003, 0.1));
    expect_scallop(found, exact);
    EXPECT_EQ(verdict(found, {0.01, exact + 0.003}), Verdict::Clean);
    // The straight steps of the path cut 25 sin(30 + ..) (1 - cos(turn / 2)) too deep.
    EXPECT_LT(found.max_gouge_mm, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(StepsAndLeads, ScallopOnADome,
                         testing::Values(std::pair{4.0, 0.0}, std::pair{4.0, 15.0},
                                         std::pair{6.0, 0.0}, std::pair{6.0, 30.0}));

// A flat or bull-nose cutter with a lead cuts an ellipse across the feed.
TEST(TurningMeasurement, ScallopOnAPlaneIsThatOfTheLeaningEllipse)
{
    const auto flat = [](double pitch) {
        return 5 * std::sin(rad(10)) * (1 - std::sqrt(1 - pitch * pitch / 100));
    };
    EXPECT_NEAR(flat(2), 0.017542028, 1e-9);
    EXPECT_NEAR(flat(4), 0.072484970, 1e-9);
    struct Case {
        Cutter cutter;
        double pitch;
        double exact;
    };
    for (const auto& [cutter, pitch, exact] :
         {Case{Cutter::flat(5), 2, flat(2)}, Case{Cutter::flat(5), 4, flat(4)},
          Case{Cutter{5, 1}, 2, 0.021097259}, Case{Cutter{5, 1}, 4, 0.088352292}}) {
        const ToolPath path = test::plane_passes(
            cutter, {.apart = pitch, .count = 5, .lead = {rad(10), rad(10)}});
        const Deviation found = measured(plane_below(6, 14, 3), path, CuttingBody{cutter},
                                         options_of(0.01, exact + 0.003, 0.2));
        expect_scallop(found, exact);
        EXPECT_EQ(verdict(found, {0.01, exact + 0.003}), Verdict::Clean);
        EXPECT_LT(found.max_gouge_mm, 1e-7);
    }
}

TEST(TurningMeasurement, FindsAGougeOfATurningAxisInItsPlace)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 1}}) {
        const ToolPath path = test::plane_passes(
            cutter, {.apart = 1, .count = 5, .lead = {rad(10), rad(25)}, .sunk = 0.05});
        const Deviation found = measured(plane_below(4, 16, 1.5), path,
                                         CuttingBody{cutter}, options_of(0.01, 0.2, 0.2));
        EXPECT_EQ(verdict(found, {0.01, 0.2}), Verdict::Gouged);
        EXPECT_LE(found.max_gouge_mm, 0.05 + 1e-6);
        EXPECT_GE(found.max_gouge_mm + found.gouge_bound_mm, 0.05 - 1e-3);
        ASSERT_TRUE(found.deepest);
        EXPECT_NEAR(found.deepest->ray.point.x(), 10, 0.5);
        EXPECT_NEAR(found.deepest->ray.point.y(), 0, 1.0);
        // The sunk point is number 2 x 43 + 21 of the path.
        EXPECT_NEAR(found.deepest->sweep, 2 * 43 + 21, 1);
    }
}

TEST(TurningMeasurement, FindsASkippedPassInItsPlace)
{
    const Cutter ball = Cutter::ball(5);
    const ToolPath path = test::plane_passes(
        ball, {.apart = 1, .count = 7, .lead = {rad(10), rad(25)}, .left_out = 3});
    const Deviation found = measured(plane_below(4, 16, 2.5), path, CuttingBody{ball},
                                     options_of(0.01, 0.04, 0.2));
    // Neighbours of the skipped pass are 2 mm apart.
    expect_scallop(found, 5 - std::sqrt(24));
    EXPECT_EQ(verdict(found, {0.01, 0.04}), Verdict::Uncut);
    ASSERT_TRUE(found.highest);
    EXPECT_NEAR(found.highest->ray.point.y(), 0, 0.2);
}

// A flat cutter that leans outward in the plane of C's axis cuts a cone.
TEST(TurningMeasurement, FlatCutterOnACircleLeavesACone)
{
    const Cutter flat = Cutter::flat(5);
    const double lean = rad(25);
    ToolPath path;
    for (int k = 0; k <= 400; ++k) {
        const double a = k * 0.005;
        const Vec3 out{std::cos(a), std::sin(a), 0};
        const Vec3 axis = std::cos(lean) * Vec3::UnitZ() + std::sin(lean) * out;
        test::add(path, k == 0 ? Move::Rapid : Move::Cut, {30 * out, axis});
    }
    // The cone under the disc: radius 30 +- 5 cos 25, here a little less on both sides.
    Nurbs cone{{2, {}}, {1, {0, 0, 1, 1}}, {}, {}};
    const test::UnitArc arc = test::unit_arc(0.5, 1.5);
    cone.u.knots = arc.knots;
    for (const double away : {-4.9, 4.9})
        for (std::size_t i = 0; i < arc.points.size(); ++i) {
            const double radius = 30 + away * std::cos(lean);
            cone.control_points.emplace_back(radius * arc.points[i].x(),
                                             radius * arc.points[i].y(),
                                             -away * std::sin(lean));
            cone.weights.push_back(arc.weights[i]);
        }
    const Deviation found = measured(std::vector<Surface>{nurbs_surface(cone)}, path,
                                     CuttingBody{flat}, options_of(0.01, 0.01, 0.2));
    // The chords of the path are 30 (1 - cos 0.0025) off, the disc's rim does not matter.
    EXPECT_LT(found.max_gouge_mm, 2e-4);
    EXPECT_LT(found.max_scallop_mm, 2e-4);
    EXPECT_EQ(verdict(found, {0.01, 0.01}), Verdict::Clean);
}

TEST(TurningMeasurement, RimOfAFlatCutterTouchesABowlOrGougesIt)
{
    const Cutter flat = Cutter::flat(5);
    const Part bowl = [] {
        const double down = -std::numbers::pi / 2;
        Nurbs sphere = test::torus(0, 30, {0, 0.3, down + rad(25), down + rad(35), 1});
        return std::vector<Surface>{nurbs_surface(sphere)};
    }();
    const auto with_lead = [&](double lead) {
        const ToolPath path = test::dome_rings(flat, {.radius = 30,
                                                      .step = rad(1),
                                                      .polar = {rad(15), rad(45)},
                                                      .azimuth = {-0.5, 0.8},
                                                      .lead = lead,
                                                      .is_hollow = true});
        return measured(bowl, path, CuttingBody{flat}, options_of(0.01, 0.02, 0.2));
    };
    const double least = std::asin(5.0 / 30);
    EXPECT_NEAR(least, rad(9.594068), 1e-7);
    EXPECT_LT(with_lead(least).max_gouge_mm, 2e-4);
    const double lead = least - rad(1);
    const double depth = std::sqrt(900 + 100 - 300 * std::sin(lead) * 2) - 30;
    EXPECT_NEAR(depth, 0.1718447, 1e-7);
    const Deviation found = with_lead(lead);
    EXPECT_LE(found.max_gouge_mm, depth + 2e-4);
    EXPECT_GE(found.max_gouge_mm + found.gouge_bound_mm, depth - 2e-4);
}

TEST(TurningMeasurement, IsTheSameWithAnyNumberOfThreads)
{
    const Cutter cutter{5, 1};
    const ToolPath path =
        test::plane_passes(cutter, {.apart = 1, .count = 5, .lead = {rad(10), rad(25)}});
    const auto found = [&] {
        return measured(plane_below(4, 16, 1.5), path, CuttingBody{cutter},
                        options_of(0.01, 0.03, 0.2));
    };
    set_thread_count(1);
    const Deviation one = found();
    for (const int threads : {2, 3, 8}) {
        set_thread_count(threads);
        const Deviation other = found();
        EXPECT_EQ(one.left, other.left);
        EXPECT_EQ(one.max_scallop_mm, other.max_scallop_mm);
        EXPECT_EQ(one.scallop_bound_mm, other.scallop_bound_mm);
        EXPECT_EQ(one.gouge_bound_mm, other.gouge_bound_mm);
    }
    set_thread_count(2);
}

TEST(TurningMeasurement, RefusesOptionsOutOfRange)
{
    const Cutter ball = Cutter::ball(5);
    const ToolPath path = test::plane_passes(ball, {});
    EXPECT_THROW(
        measured(plane_below(4, 5, 1), path, CuttingBody{ball}, options_of(0, 0.1, 0.2)),
        DomainError);
    EXPECT_THROW(
        measured(plane_below(4, 5, 1), path, CuttingBody{ball}, options_of(0.1, 0, 0.2)),
        DomainError);
}

// Check [28] of docs/methods/five-axis-paths.md, section 9: a flat cutter with a lead along a
// convex cylinder. Across the feed its disc is an ellipse of half axes R and R sin(lead).
TEST(TurningMeasurement, ScallopOnACylinderIsThatOfTheLeaningEllipse)
{
    const Cutter flat = Cutter::flat(5);
    const double radius = 20;
    const double lead = rad(10);
    const double minor = 5 * std::sin(lead);
    const auto scallop = [&](double step) {
        const double t = std::tan(step / 2);
        const double angle =
            std::asin(t * (radius + minor) / std::sqrt(25 + minor * minor * t * t)) -
            std::atan2(minor * t, 5);
        return (radius + minor - minor * std::cos(angle)) / std::cos(step / 2) - radius;
    };
    EXPECT_NEAR(scallop(rad(4)), 0.020715374, 1e-9);
    EXPECT_NEAR(scallop(rad(6)), 0.046803019, 1e-9);
    for (const double step : {rad(4), rad(6)}) {
        ToolPath path;
        for (int i = -3; i <= 4; ++i) {
            const double a = std::numbers::pi / 2 + i * step;
            const Vec3 out{0, std::cos(a), std::sin(a)};
            for (const double x : {-10.0, 30.0}) {
                const CutterLocation here =
                    test::leaning(flat, {{x, radius * out.y(), radius * out.z()}, out},
                                  Vec3::UnitX(), lead);
                if (x < 0)
                    test::add(path, path.points.empty() ? Move::Rapid : Move::Link,
                              {here.tip + 20 * here.axis, here.axis});
                test::add(path, Move::Cut, here);
                if (x > 0)
                    test::add(path, Move::Retract,
                              {here.tip + 20 * here.axis, here.axis});
            }
        }
        const double middle = std::numbers::pi / 2;
        const Part part = std::vector<Surface>{nurbs_surface(
            test::cylinder(radius, 8, middle - 1.2 * step, middle + 2.2 * step))};
        const double exact = scallop(step);
        const Deviation found =
            measured(part, path, CuttingBody{flat}, options_of(0.01, exact + 0.003, 0.2));
        expect_scallop(found, exact);
        EXPECT_EQ(verdict(found, {0.01, exact + 0.003}), Verdict::Clean);
        EXPECT_LT(found.max_gouge_mm, 1e-6);
    }
}

// Check [25] of docs/methods/five-axis-paths.md, section 9: the flank of a flat cutter along a
// generator of a cone, outside, while the cone turns.
TEST(TurningMeasurement, FlankAlongAGeneratorLeavesACone)
{
    const Cutter flat = Cutter::flat(5);
    const double lean = rad(25);
    // In the plane of C's axis: along the generator, upwards and inwards, and out of the
    // cone, which has the radius 30 at z = 0.
    const auto frame = [&](double a) {
        const Vec3 out{std::cos(a), std::sin(a), 0};
        return std::pair{Vec3{std::cos(lean) * Vec3::UnitZ() - std::sin(lean) * out},
                         Vec3{std::cos(lean) * out + std::sin(lean) * Vec3::UnitZ()}};
    };
    ToolPath path;
    for (int k = 0; k <= 400; ++k) {
        const double a = k * 0.005;
        const auto [along, normal] = frame(a);
        const Vec3 on_cone{30 * std::cos(a), 30 * std::sin(a), 0};
        test::add(path, k == 0 ? Move::Rapid : Move::Cut,
                  {on_cone - 12 * along + 5 * normal, along});
    }
    Nurbs cone{{2, {}}, {1, {0, 0, 1, 1}}, {}, {}};
    const test::UnitArc arc = test::unit_arc(0.5, 1.5);
    cone.u.knots = arc.knots;
    for (const double up : {-5.0, 5.0})
        for (std::size_t i = 0; i < arc.points.size(); ++i) {
            const double radius = 30 - up * std::sin(lean);
            cone.control_points.emplace_back(radius * arc.points[i].x(),
                                             radius * arc.points[i].y(),
                                             up * std::cos(lean));
            cone.weights.push_back(arc.weights[i]);
        }
    for (const double length : {std::numeric_limits<double>::infinity(), 30.0}) {
        const Deviation found =
            measured(std::vector<Surface>{nurbs_surface(cone)}, path,
                     CuttingBody{flat, length}, options_of(0.01, 0.01, 0.2));
        // The chords of the path are (30 + 12) (1 - cos 0.0025) off.
        EXPECT_LT(found.max_gouge_mm, 2e-4);
        EXPECT_LT(found.max_scallop_mm, 2e-4);
        EXPECT_NE(verdict(found, {0.01, 0.01}), Verdict::Gouged);
        EXPECT_NE(verdict(found, {0.01, 0.01}), Verdict::Uncut);
    }
}

}  // namespace
}  // namespace endmill
