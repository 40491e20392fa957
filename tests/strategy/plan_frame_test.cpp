// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/plan_frame.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/verification/verification.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::box_mesh;
using test::grid_mesh;

// A shallow dome of 16 x 12 mm.
Part dome()
{
    return grid_mesh(16, 12, [](int i, int j) {
        const double x = i - 8;
        const double y = j - 6;
        return Vec3{x, y, -(x * x + y * y) / 60};
    });
}

StrategyOptions coarse()
{
    StrategyOptions options;
    options.scallop_height = 0.2;
    options.inner_tolerance = 0.02;
    options.link.safe_height = 10;
    options.direction = Angle::degrees(0);
    return options;
}

const Cutter ball = Cutter::ball(3);

// A rotation without rounding: z becomes x.
Eigen::Matrix3d quarter_turn()
{
    Eigen::Matrix3d rotation;
    rotation << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    return rotation;
}

TEST(PlanInFrame, PlansTheRotatedPartAndRotatesThePathBack)
{
    const Eigen::Matrix3d rotation = quarter_turn();
    const Part lying = turned(dome(), rotation.transpose());
    const BestPlan upright = plan_in_frame({}, Strategy::Planar, dome(), ball, coarse());
    const BestPlan found =
        plan_in_frame({rotation}, Strategy::Planar, lying, ball, coarse());
    const ToolPath& expected = upright.plan.covering.path;
    const ToolPath& path = found.plan.covering.path;
    ASSERT_EQ(path.points.size(), expected.points.size());
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        EXPECT_EQ(point.location.axis, Vec3::UnitX());
        EXPECT_LT(
            (rotation * point.location.tip - expected.points[k].location.tip).norm(),
            1e-12);
        ASSERT_EQ(point.contact() != nullptr, expected.points[k].contact() != nullptr);
        if (const SurfaceContact* contact = point.contact()) {
            EXPECT_LT((rotation * contact->contact.normal -
                       expected.points[k].contact()->contact.normal)
                          .norm(),
                      1e-12);
        }
    }
    EXPECT_EQ(found.plan.verdict, Verdict::Clean);
    EXPECT_EQ(found.plan.verdict, upright.plan.verdict);
}

TEST(PlanInFrame, RotatesTheProtectedPartToo)
{
    const Eigen::Matrix3d rotation = quarter_turn();
    const Part wall = box_mesh({5, -20, -20}, {30, 20, 8});
    const Part lying_wall = turned(wall, rotation.transpose());
    const Part lying = turned(dome(), rotation.transpose());
    const BestPlan found =
        plan_in_frame({rotation, &lying_wall}, Strategy::Planar, lying, ball, coarse());
    for (const PathPoint& point : found.plan.covering.path.points) {
        const Vec3 tip = rotation * point.location.tip;
        EXPECT_TRUE(tip.x() <= 5 - 3 || tip.z() >= 8) << tip.transpose();
    }
    EXPECT_GT(found.plan.covering.unreached_mm2, 0);
    ASSERT_TRUE(found.plan.of_protected);
    EXPECT_LE(found.plan.of_protected->max_gouge_mm, 0.02);
}

TEST(PlanInFrame, NeedsARotation)
{
    EXPECT_THROW(plan_in_frame({2 * Eigen::Matrix3d::Identity()}, Strategy::Planar,
                               dome(), ball, coarse()),
                 DomainError);
    EXPECT_THROW(plan_in_frame({-Eigen::Matrix3d::Identity()}, Strategy::Planar, dome(),
                               ball, coarse()),
                 DomainError);
    EXPECT_THROW(plan_in_frame({}, std::nullopt, dome(), Cutter::flat(3), coarse()),
                 DomainError);
}

}  // namespace
}  // namespace endmill
