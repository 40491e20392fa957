// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/iso_parametric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/path_interval.h"
#include "planned_path.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using test::contact_point;
using test::passes_of;

IsoParametricOptions tolerances(double delta, double h,
                                Parameter direction = Parameter::U)
{
    IsoParametricOptions options;
    options.direction = direction;
    options.chord_tolerance = delta;
    options.scallop_height = h;
    return options;
}

// On a plane a ball of radius 5 leaves scallops of 1 mm at the interval 2 sqrt(2 5 1 - 1)
// = 6 mm.
IsoParametricPlan plan_six_mm(const Surface& surface, Parameter direction = Parameter::U)
{
    return plan_iso_parametric(surface, BallCutter{5}, tolerances(0.5, 1, direction));
}

TEST(IsoParametric, OnAPlaneHasThePathOfTheClosedForm)
{
    const ToolPath path = plan_six_mm(test::plane(200, 120, {3, 2})).path;
    ASSERT_EQ(path.points.size(), 42U) << "21 passes, not 22: 120 / 6 divides exactly";
    for (int k = 0; k < 42; ++k) {
        const PathPoint& point = path.points[k];
        const bool at_far_end = k % 4 == 1 || k % 4 == 2;  // zigzag
        const int pass = k / 2;
        const Vec3 expected{at_far_end ? 200.0 : 0.0, 6.0 * pass, 0};
        EXPECT_LT((contact_point(point) - expected).norm(), 1e-9) << k;
        EXPECT_LT((point.location.tip - expected).norm(), 1e-9) << k;
        EXPECT_EQ(point.contact()->contact.normal, Vec3::UnitZ());
        EXPECT_EQ(point.contact()->u, at_far_end ? 3 : 0);
        EXPECT_EQ(point.pass, pass);
        EXPECT_EQ(point.point, k % 2);
        EXPECT_EQ(point.move, k == 0       ? Move::Plunge
                              : k % 2 == 1 ? Move::Cut
                                           : Move::Link);
    }
    const PathEconomy economy = path_economy(path);
    EXPECT_NEAR(economy.cut.contact_mm, 21 * 200, 1e-9);
    EXPECT_NEAR(economy.link.contact_mm, 120, 1e-9);
    EXPECT_NEAR(economy.cut.tip_mm, 21 * 200, 1e-9);
}

// Enough contacts for several blocks of memory.
TEST(IsoParametric, OfTwelveThousandPointsOnAPlaneHasThePathOfTheClosedForm)
{
    const double h = 1e-5;
    const double interval = 2 * std::sqrt(2 * 5 * h - h * h);
    const Surface plane = test::plane(200, 120, {3, 2});
    const ToolPath path =
        plan_iso_parametric(plane, BallCutter{5}, tolerances(0.5, h)).path;
    const auto whole = static_cast<std::size_t>(120 / interval);
    ASSERT_EQ(path.points.size(), 2 * (whole + 2)) << "and a pass on the border";
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const bool at_far_end = k % 4 == 1 || k % 4 == 2;  // zigzag
        const double y = std::min(120.0, interval * static_cast<double>(k / 2));
        const Vec3 expected{at_far_end ? 200.0 : 0.0, y, 0};
        EXPECT_LT((contact_point(path.points[k]) - expected).norm(), 1e-8) << k;
        EXPECT_EQ(path.points[k].pass, static_cast<int>(k / 2));
        EXPECT_EQ(path.points[k].point, static_cast<int>(k % 2));
    }
}

TEST(IsoParametric, AlongVOnAPlaneHasOnePassMoreThanWholeIntervals)
{
    const PathEconomy economy =
        path_economy(plan_six_mm(test::plane(200, 120, {3, 2}), Parameter::V).path);
    EXPECT_EQ(economy.passes, 35U) << "200 / 6 = 33.3";
    EXPECT_EQ(economy.ncl, 70U);
    EXPECT_NEAR(economy.cut.contact_mm, 35 * 120, 1e-9);
    EXPECT_NEAR(economy.link.contact_mm, 200, 1e-9);
}

TEST(IsoParametric, OnAPlaneOfWholeIntervalsHasOnePassMoreThanIntervals)
{
    const double interval = 2 * std::sqrt(2 * 7.5 * 0.5 - 0.25);
    for (const int intervals : {1, 2, 3, 7, 20, 50}) {
        const Surface plane = test::plane(10, intervals * interval, {1, 3});
        const IsoParametricPlan plan =
            plan_iso_parametric(plane, BallCutter{7.5}, tolerances(0.5, 0.5));
        EXPECT_EQ(path_economy(plan.path).passes, intervals + 1U);
    }
}

TEST(IsoParametric, MeasuresTheIntervalOfATiltedPlaneOnThePlane)
{
    const Eigen::AngleAxisd tilt{0.6, Vec3{1, 2, 0}.normalized()};
    const Surface plane =
        test::parallelogram(tilt * Vec3{200, 0, 0}, tilt * Vec3{0, 120, 0}, {3, 2});
    const ToolPath path = plan_six_mm(plane).path;
    const auto passes = passes_of(path);
    ASSERT_EQ(passes.size(), 21U);
    for (std::size_t k = 0; k < passes.size(); ++k) {
        ASSERT_EQ(passes[k].size(), 2U);
        const Vec3 start = tilt.inverse() * contact_point(passes[k][k % 2]);
        EXPECT_LT((start - Vec3{0, 6.0 * double(k), 0}).norm(), 1e-9);
    }
    const Vec3 centre = path.points[0].location.tip + 5 * Vec3::UnitZ();
    EXPECT_LT((centre - 5 * (tilt * Vec3::UnitZ())).norm(), 1e-12);
}

TEST(IsoParametric, MeasuresTheIntervalOfAShearedPlaneAcrossTheFeed)
{
    const Surface plane = test::parallelogram({200, 0, 0}, {60, 120, 0}, {3, 2});
    const PathEconomy along_u = path_economy(plan_six_mm(plane).path);
    EXPECT_EQ(along_u.passes, 21U) << "120 mm wide";
    EXPECT_EQ(along_u.ncl, 42U);
    EXPECT_NEAR(along_u.cut.contact_mm, 21 * 200, 1e-9);
    EXPECT_NEAR(along_u.link.contact_mm, std::hypot(60, 120), 1e-9);

    const PathEconomy along_v = path_economy(plan_six_mm(plane, Parameter::V).path);
    const double side = std::hypot(60, 120);
    const double width = 200 * 120 / side;  // 178.9 mm, 29.8 intervals
    EXPECT_EQ(along_v.passes, std::size_t(std::ceil(width / 6)) + 1);
    EXPECT_NEAR(along_v.cut.contact_mm, double(along_v.passes) * side, 1e-9);
    EXPECT_NEAR(along_v.link.contact_mm, 200, 1e-9);
}

TEST(IsoParametric, OnStraightLinesHasTwoPointsAPassThoughTheSurfaceIsCurved)
{
    const Surface ruled =
        test::graph(test::monomial(1, 1, 0.02), {{-30, 40}, {-20, 30}}, {3, 2});
    for (const Parameter direction : {Parameter::U, Parameter::V})
        for (const auto& pass : passes_of(plan_six_mm(ruled, direction).path))
            EXPECT_EQ(pass.size(), 2U);
}

// The X on z = bend x^2 / 2 that lies `distance` beyond `x` along the tangent at `x`:
// (X - x) + s bend (X^2 - x^2) / 2 = distance sqrt(1 + s^2), s = bend x.
double beyond_on_parabola(double bend, double x, double distance)
{
    const double s = bend * x;
    const double a = s * bend / 2;
    const double c = -(x + a * x * x + distance * std::hypot(1, s));
    return -2 * c / (1 + std::sqrt(1 - 4 * a * c));
}

double parabola_curvature(double bend, double x)
{
    return bend / std::pow(1 + bend * bend * x * x, 1.5);
}

TEST(IsoParametric,
     StepsOnAParabolaAreThoseOfTheClosedForm)  // [KimChoi, eq. (1), (2), (3)]
{
    for (const double bend : {0.03, -0.03})
        for (const double delta : {0.5, 0.01}) {
            const Surface cylinder = test::parabolic_cylinder(bend, 40, 30, {3, 2});
            const auto pass = passes_of(
                plan_iso_parametric(cylinder, BallCutter{5}, tolerances(delta, 1))
                    .path)[0];
            double x = -40;
            std::size_t k = 0;
            for (; x < 40; ++k) {
                ASSERT_LT(k, pass.size());
                EXPECT_NEAR(contact_point(pass[k]).x(), x, 1e-9) << k;
                const double sagitta = delta * parabola_curvature(std::abs(bend), x);
                const double chord = 2 * std::sqrt(delta * delta * (2 / sagitta - 1));
                x = beyond_on_parabola(bend, x, chord * (1 - sagitta));
            }
            ASSERT_EQ(pass.size(), k + 1);
            EXPECT_NEAR(contact_point(pass[k]).x(), 40, 1e-12)
                << "the last step is short";
        }
}

TEST(IsoParametric,
     PassesAcrossAParabolaAreThoseOfTheClosedForm)  // [KimChoi, eq. (4)-(10)]
{
    constexpr double bend = 0.03;
    constexpr double R = 5;
    constexpr double h = 0.4;
    for (const double sign : {1.0, -1.0}) {
        const Surface cylinder = test::parabolic_cylinder(sign * bend, 40, 30, {3, 2});
        const auto passes = passes_of(
            plan_iso_parametric(cylinder, BallCutter{R}, tolerances(0.5, h, Parameter::V))
                .path);
        double x = -40;
        std::size_t n = 0;
        for (; x < 40; ++n) {
            ASSERT_LT(n, passes.size());
            ASSERT_EQ(passes[n].size(), 2U);
            EXPECT_NEAR(contact_point(passes[n][0]).x(), x, 1e-8) << n;
            // Law of cosines in the triangle of circle centre, ball centre and peak.
            const double rho =
                -sign / parabola_curvature(bend, x);  // convex where bent down
            const double a = rho + R;
            const double b = rho + h;
            const double alpha = std::acos((a * a + b * b - R * R) / (2 * a * b));
            x = beyond_on_parabola(sign * bend, x, std::abs(rho) * std::sin(2 * alpha));
        }
        ASSERT_EQ(passes.size(), n + 1);
        EXPECT_NEAR(contact_point(passes[n][0]).x(), 40, 1e-12);
    }
}

TEST(IsoParametric, NamesThePointThatGovernsEveryPassButTheLast)
{
    const Surface surface = test::saddle(40, 50, {3, 2});
    const IsoParametricPlan plan =
        plan_iso_parametric(surface, BallCutter{5}, tolerances(0.5, 0.5));
    const auto passes = passes_of(plan.path);
    ASSERT_EQ(plan.governing.size(), passes.size());
    EXPECT_FALSE(plan.governing.back());
    for (std::size_t n = 0; n + 2 < passes.size(); ++n) {
        ASSERT_TRUE(plan.governing[n]);
        EXPECT_EQ(plan.governing[n]->at.v, passes[n][0].contact()->v);
        EXPECT_EQ(plan.governing[n]->partner.v, passes[n + 1][0].contact()->v);
        EXPECT_TRUE(std::ranges::any_of(passes[n], [&](const PathPoint& point) {
            return point.contact()->u == plan.governing[n]->at.u;
        }));
    }
}

TEST(IsoParametric, ReportsProgressAfterEveryPass)
{
    std::vector<double> shares;
    IsoParametricOptions options = tolerances(0.5, 1);
    options.progress = [&](double share) { shares.push_back(share); };
    plan_iso_parametric(test::plane(200, 120), BallCutter{5}, options);
    ASSERT_EQ(shares.size(), 21U);
    for (std::size_t k = 0; k < shares.size(); ++k)
        EXPECT_NEAR(shares[k], 0.05 * double(k), 1e-9);
}

TEST(IsoParametric, StopsAtTheMostPointsAllowed)
{
    IsoParametricOptions options = tolerances(0.5, 1);
    options.most_points = 42;
    EXPECT_NO_THROW(plan_iso_parametric(test::plane(200, 120), BallCutter{5}, options));
    options.most_points = 41;
    EXPECT_THROW(plan_iso_parametric(test::plane(200, 120), BallCutter{5}, options),
                 LimitError);
}

TEST(IsoParametric, RefusesArgumentsOutsideItsDomain)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto plan = [](const IsoParametricOptions& options) {
        return plan_iso_parametric(test::plane(20, 12), BallCutter{5}, options);
    };
    for (const double delta : {0.0, -1.0, nan, infinity})
        EXPECT_THROW(plan(tolerances(delta, 1)), DomainError) << delta;
    for (const double h : {0.0, -1.0, 10.0, nan, infinity})
        EXPECT_THROW(plan(tolerances(0.5, h)), DomainError) << h;
    for (const double step : {0.0, -1.0, nan, infinity}) {
        IsoParametricOptions options = tolerances(0.5, 1);
        options.cross_curvature = CrossCurvature::Chord;
        options.cross_step = step;
        EXPECT_THROW(plan(options), DomainError) << step;
    }
    for (const Vec3& axis : {Vec3{0, 0, 0}, {0, 0, 1.1}, {nan, 0, 1}}) {
        IsoParametricOptions options = tolerances(0.5, 1);
        options.link.axis = axis;
        EXPECT_THROW(plan(options), DomainError) << axis.transpose();
    }
}

// The message of the GeometryError that the planner throws; empty if it throws none.
std::string refusal(const Surface& surface, double R, const IsoParametricOptions& options)
{
    try {
        plan_iso_parametric(surface, BallCutter{R}, options);
    } catch (const GeometryError& error) {
        return error.what();
    }
    return {};
}

void expect_text(const std::string& message, const std::string& part)
{
    EXPECT_NE(message.find(part), std::string::npos) << '"' << message << '"';
}

TEST(IsoParametric, RefusesABallThatDoesNotFitAndNamesThePlace)
{
    // The tightest place of z = x^2 / 40 is x = 0, in the middle of u, with radius 20.
    const Surface trough = test::parabolic_cylinder(0.05, 30, 10, {2, 1});
    IsoParametricOptions options = tolerances(0.5, 0.01, Parameter::V);
    EXPECT_EQ(refusal(trough, 19.9, options), "");
    const std::string message = refusal(trough, 25, options);
    expect_text(message, "radius 25 mm");
    expect_text(message, "u = 0.");
    expect_text(message, "v = 0");
}

TEST(IsoParametric, RefusesASurfaceThatTurnsAwayFromTheAxis)
{
    const Surface wall = test::parallelogram({20, 0, 0}, {0, 1e-14, 10});
    expect_text(refusal(wall, 5, tolerances(0.5, 1)), "normal . axis");
    IsoParametricOptions sideways = tolerances(0.5, 1);
    sideways.link.axis = -Vec3::UnitY();
    EXPECT_EQ(refusal(wall, 5, sideways), "") << "seen from the side it is a plane";

    const Surface seen_from_below =
        composite_bezier(1, 1, test::random_net(1, {1, 1}, 0), ToolSide::DvCrossDu);
    expect_text(refusal(seen_from_below, 5, tolerances(0.5, 1)), "u = 0, v = 0");
}

TEST(IsoParametric, RefusesASurfaceThatIsALineOrAPoint)
{
    const Vec3 along{3, 1, 2};
    EXPECT_NE(refusal(test::parallelogram(along, 2 * along), 5, tolerances(0.5, 1)), "");
    const Surface point = composite_bezier(1, 1, std::vector<Vec3>(16, Vec3{1, 2, 3}));
    EXPECT_NE(refusal(point, 5, tolerances(0.5, 1)), "");
}

TEST(IsoParametric, RefusesPassesThatMakeNoProgress)
{
    // An interval of 6 mm is less than a ten-thousandth of a patch of 100 m.
    expect_text(refusal(test::plane(10, 1e5), 5, tolerances(0.5, 1)), "no progress");
}

TEST(EstimatedPoints, AreRightToAFactorOfAboutTwo)
{
    for (const Surface& surface :
         {test::plane(200, 120, {3, 2}), test::saddle(40, 60, {2, 2}),
          test::parabolic_cylinder(0.03, 60, 90, {3, 1}),
          test::graph(test::monomial(3, 0, 4e-5) + test::monomial(0, 2, -0.01),
                      {{-50, 50}, {-40, 40}}, {2, 3})})
        for (const Parameter direction : {Parameter::U, Parameter::V}) {
            const IsoParametricOptions options = tolerances(0.05, 0.05, direction);
            const BallCutter ball{5};
            const double estimate = estimated_points(surface, ball, options);
            const double found =
                double(plan_iso_parametric(surface, ball, options).path.points.size());
            EXPECT_GT(estimate, found / 2.5);
            EXPECT_LT(estimate, found * 2.5);
        }
}

}  // namespace
}  // namespace endmill
