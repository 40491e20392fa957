// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/verified_plan.h"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/path_error.h"
#include "normal_depth.h"
#include "planned_path.h"
#include "revolved_surfaces.h"
#include "swept_deviation.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

Surface net(const std::string& name)
{
    std::ifstream file{ENDMILL_SOURCE_DIR "/datasets/surfaces/" + name + ".json"};
    const nlohmann::json json = nlohmann::json::parse(file);
    std::vector<Vec3> points;
    for (const auto& row : json.at("control_points"))
        for (const auto& point : row)
            points.emplace_back(point.at(0), point.at(1), point.at(2));
    return composite_bezier(json.at("patches_u"), json.at("patches_v"), points);
}

struct Demand {
    double radius;
    MotionTolerances tolerances;
    double scallop;
};

VerifiedOptions options_of(const Demand& demand, Parameter direction)
{
    VerifiedOptions options;
    options.direction = direction;
    options.tolerances = demand.tolerances;
    options.scallop_height = demand.scallop;
    options.link.safe_height = 400;
    return options;
}

// Plans in both directions and checks the tolerances at samples of the surfaces, without
// bounds.
void expect_kept(const std::vector<Surface>& part, const Demand& demand, int count)
{
    const BallCutter ball{demand.radius};
    for (const Parameter direction : {Parameter::U, Parameter::V}) {
        const VerifiedPlan plan =
            plan_verified(part, ball, options_of(demand, direction));
        EXPECT_TRUE(plan.uncovered.empty());
        const test::SweptDeviation deviation =
            test::swept_deviation(part, plan.path, demand.radius,
                                  demand.scallop + demand.tolerances.outer, count);
        EXPECT_LE(deviation.gouge, demand.tolerances.inner);
        EXPECT_LE(deviation.beyond_height, 1e-9);
        const MotionError error = motion_error(part, plan.path, ball, direction);
        EXPECT_LE(error.gouge.greatest_mm, demand.tolerances.inner + error.bound_mm);
        EXPECT_LE(error.remaining.greatest_mm, demand.tolerances.outer + error.bound_mm);
    }
}

TEST(VerifiedPlan, KeepsItsTolerancesOnTheFittedNets)
{
    for (const char* name : {"net_rot24_7D", "net_symV24_1A"})
        expect_kept({net(name)}, {7.5, {0.5, 0.5}, 0.5}, 25);
}

// Beside the border the ball reaches below the part. Along the normals there it cuts
// deeper than any point of the part lies in it.
TEST(VerifiedPlan, KeepsItsToleranceAlongTheNormalsAtTheBorder)
{
    for (const char* name : {"net_full48_41D", "net_rot24_7D"}) {
        const Surface part = net(name);
        for (const Demand& demand :
             {Demand{7.5, {0.5, 0.5}, 0.5}, Demand{7.5, {1.5, 1.5}, 0.1}}) {
            const VerifiedPlan plan = plan_verified({&part, 1}, BallCutter{7.5},
                                                    options_of(demand, Parameter::V));
            for (const double inset : {0.0, 1e-5, 1e-4})
                EXPECT_LE(test::border_depth(part, plan.path, 7.5, 1500, inset),
                          demand.tolerances.inner);
        }
    }
}

TEST(VerifiedPlan, KeepsOneSidedTolerances)
{
    expect_kept({net("net_rot24_7D")}, {7.5, {0.05, 0.8}, 1}, 20);
    expect_kept({net("net_rot24_7D")}, {7.5, {1, 0.05}, 1}, 20);
}

TEST(VerifiedPlan, KeepsItsTolerancesOnSurfacesOfRevolution)
{
    expect_kept({nurbs_surface(test::torus(30, 12, {0, 1.5, 0.4, 2.6, 2}))},
                {4, {0.1, 0.1}, 0.1}, 30);
    expect_kept({nurbs_surface(test::torus(0, 20, {0, 1.5, 0.3, pi / 2}))},
                {4, {0.1, 0.05}, 0.1}, 30);
    expect_kept({nurbs_surface(test::cylinder(20, 30, 0.6, 2.5, 2))},
                {4, {0.05, 0.1}, 0.1}, 30);
}

TEST(VerifiedPlan, KeepsItsTolerancesWherePatchesHaveWeights)
{
    expect_kept({Surface{{0, 1}, {0, 1}, {test::random_patch(6, 3, 4, true, 1.5)}}},
                {2, {0.05, 0.05}, 0.1}, 30);
}

// A wall beside a floor, as two surfaces: a ball on the border of the floor would enter
// the wall.
TEST(VerifiedPlan, RespectsAllSurfacesOfThePart)
{
    constexpr double radius = 4;
    const std::vector<Surface> part{
        test::plane(40, 30),
        test::parallelogram({0, 30, 0}, {-10, 0, 20})};  // on the border x = 0
    const Demand demand{radius, {0.05, 0.05}, 0.2};
    const VerifiedPlan plan =
        plan_verified(part, BallCutter{radius}, options_of(demand, Parameter::U));
    const test::SweptDeviation deviation =
        test::swept_deviation(part, plan.path, radius, 0.25, 60);
    EXPECT_LE(deviation.gouge, 0.05);
    EXPECT_FALSE(plan.uncovered.empty());  // in the corner
}

// A link between passes along a cylinder is a chord, and gouges by its sagitta. The
// sagitta exceeds the small inner tolerance, but not the large one.
TEST(VerifiedPlan, LiftsLinksThatWouldGouge)
{
    const std::vector<Surface> part{nurbs_surface(test::cylinder(20, 30, 0.8, 2.3))};
    const BallCutter ball{5};
    const auto planned = [&](double inner) {
        return plan_verified(part, ball,
                             options_of({5, {inner, 0.01}, 0.1}, Parameter::U));
    };
    const VerifiedPlan free = planned(0.3);
    EXPECT_EQ(free.lifted_links, 0U);
    const VerifiedPlan tight = planned(0.01);
    EXPECT_GE(tight.lifted_links, path_economy(tight.path).passes - 2);
    EXPECT_EQ(path_economy(tight.path).cut.contact_mm,
              path_economy(free.path).cut.contact_mm);
    for (std::size_t k = 1; k < tight.path.points.size(); ++k)
        if (tight.path.points[k].move == Move::Rapid) {
            EXPECT_EQ(tight.path.points[k].location.tip.z(), 400);
        }
}

TEST(VerifiedPlan, PlansAlongOtherAxes)
{
    const Vec3 axis = Vec3{0.3, -0.2, 1}.normalized();
    const std::vector<Surface> part{test::saddle(30, 15, {2, 2})};
    VerifiedOptions options = options_of({4, {0.05, 0.05}, 0.1}, Parameter::V);
    options.link.axis = axis;
    const VerifiedPlan plan = plan_verified(part, BallCutter{4}, options);
    const test::SweptDeviation deviation =
        test::swept_deviation(part, plan.path, 4, 0.15, 60);
    EXPECT_LE(deviation.gouge, 0.05);
    EXPECT_LE(deviation.beyond_height, 1e-9);
}

TEST(VerifiedPlan, IsTheSameWithAnyNumberOfThreads)
{
    const std::vector<Surface> part{test::saddle(30, 25, {2, 2})};
    const VerifiedOptions options = options_of({4, {0.05, 0.05}, 0.1}, Parameter::U);
    const ToolPath path = plan_verified(part, BallCutter{4}, options).path;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        EXPECT_TRUE(
            test::are_equal(plan_verified(part, BallCutter{4}, options).path, path));
    }
}

TEST(VerifiedPlan, ScalesWithItsInput)
{
    const auto points = [](double scale) {
        const Demand demand{4 * scale, {0.05 * scale, 0.05 * scale}, 0.1 * scale};
        VerifiedOptions options = options_of(demand, Parameter::U);
        options.link.safe_height = 400 * scale;
        const std::vector<Surface> part{test::saddle(30 * scale, 15 * scale)};
        return plan_verified(part, BallCutter{demand.radius}, options).path.points.size();
    };
    EXPECT_EQ(points(1024), points(1));
    EXPECT_EQ(points(1.0 / 1024), points(1));
}

TEST(VerifiedPlan, RefusesOptionsOutOfRange)
{
    const std::vector<Surface> part{test::plane(10, 10)};
    const auto plan = [&](const Demand& demand) {
        return plan_verified(part, BallCutter{2}, options_of(demand, Parameter::U));
    };
    EXPECT_THROW(plan({2, {0, 0}, 0.1}), DomainError);
    EXPECT_THROW(plan({2, {0, 2}, 0.1}), DomainError);
    EXPECT_THROW(plan({2, {-0.1, 0.1}, 0.1}), DomainError);
    EXPECT_THROW(plan({2, {2, 0.1}, 0.1}), DomainError);
    EXPECT_THROW(plan({2, {0.1, std::nan("")}, 0.1}), DomainError);
    EXPECT_THROW(plan({2, {0.1, 0.1}, 4}), DomainError);
    const std::vector<Surface> overhang{test::parallelogram({10, 0, 0}, {0, 1, -20}),
                                        test::parallelogram({10, 0, 0}, {0, 0, 10})};
    EXPECT_THROW(plan_verified(overhang, BallCutter{2},
                               options_of({2, {0.1, 0.1}, 0.1}, Parameter::U)),
                 GeometryError);
    // A valley so narrow that the ball fits nowhere in it.
    const std::vector<Surface> narrow{test::valley(1, 10, 3)};
    EXPECT_THROW(plan_verified(narrow, BallCutter{4},
                               options_of({4, {0.01, 0.1}, 0.1}, Parameter::U)),
                 GeometryError);
}

}  // namespace
}  // namespace endmill
