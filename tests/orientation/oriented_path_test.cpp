// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/oriented_path.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"

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
        for (int part = 0; part <= 10; ++part)
            least = std::min(least, body.distance(motion.seen(point, part / 10.0)).value);
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
    EXPECT_NEAR(plan.least_lead.degrees(), 10, 1e-12);
    EXPECT_NEAR(plan.greatest_lead.degrees(), 10, 1e-12);
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

TEST(PlanOriented, TakesTheLeadThatTheBowlNeeds)
{
    const auto bowl = paraboloid(0.03, 0.03);
    const OrientedPath plan =
        plan_oriented(bowl, Cutter{5, 1}, options_of(AxisMode::Lead, 0));
    // the greatest concave curvature is 0.03, at the middle
    const double heel = std::asin(4 / (1 / 0.03 - 1)) * 180 / std::acos(-1.0);
    EXPECT_NEAR(plan.least_lead.degrees(), heel + 1, 0.01);
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
    EXPECT_THROW(plan_oriented({}, Cutter{5, 1}, wrong), DomainError);
}

}  // namespace
}  // namespace endmill
