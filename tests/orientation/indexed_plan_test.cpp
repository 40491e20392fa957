// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/indexed_plan.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/verification/verification.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::box_mesh;
using testing::ElementsAre;

const BallCutter ball{2};

TriangleMesh cube()
{
    return box_mesh({0, 0, 0}, {8, 8, 8});
}

// The facets of the bottom of the cube.
const std::vector<std::size_t> bottom{0, 1};

IndexedOptions coarse(const std::vector<Vec3>& directions)
{
    IndexedOptions options;
    for (const Vec3& direction : directions)
        options.directions.push_back(direction.normalized());
    options.strategy = Strategy::Planar;
    options.scallop_height = 0.2;
    options.inner_tolerance = 0.02;
    return options;
}

// Two directions suffice for a cube, all but its bottom. Source:
// docs/methods/five-axis-planning.md, section 6.
TEST(IndexedPlan, OfACubeIsCleanFromTwoDirections)
{
    IndexedOptions options = coarse({{1, 1, 1}, {-1, -1, 1}});
    options.skipped = bottom;
    const IndexedPlan plan = plan_indexed(cube(), ball, options);
    EXPECT_TRUE(plan.uncovered.empty());
    ASSERT_EQ(plan.cuts.size(), 2U);
    for (const IndexedCut& cut : plan.cuts) {
        ASSERT_TRUE(cut.best) << cut.refusal;
        EXPECT_TRUE(cut.best->plan.is_good());
    }
    EXPECT_TRUE(plan.is_good());
    // the proof does not use the regions
    const Part part = cube();
    const Cutter cutter = Cutter::ball(ball.radius());
    VerificationTask task{
        .path = &plan.path,
        .cutter = cutter,
        .judged = JudgedPart{&part, {.tolerance = 0.02, .scallop = 0.2}},
        .stock = default_block(&part, plan.path, cutter)};
    task.judged->skipped_facets = bottom;
    task.engine = RemovalEngine::FiveAxis;
    task.resolution = 0.5;
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::Clean)
        << found.on_part->deviation.max_gouge_mm << ' '
        << found.on_part->deviation.max_scallop_mm << ' '
        << found.on_part->deviation.scallop_bound_mm;
    EXPECT_EQ(found.contacts.rapid_cuts.count, 0U);
}

TEST(IndexedPlan, NamesFacetsThatNoDirectionSees)
{
    const IndexedPlan plan = plan_indexed(cube(), ball, coarse({{0.2, 0.3, 1}}));
    EXPECT_FALSE(plan.is_good());
    ASSERT_EQ(plan.cuts.size(), 1U);
    EXPECT_FALSE(plan.path.points.empty());
    // bottom and the sides at y = 0 and x = 0
    EXPECT_THAT(plan.uncovered, ElementsAre(0, 1, 4, 5, 8, 9));
}

TEST(IndexedPlan, DoesNotDependOnTheNumberOfThreads)
{
    IndexedOptions options = coarse({{1, 1, 1}, {-1, -1, 1}});
    options.scallop_height = 0.5;
    std::vector<ToolPath> paths;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        paths.push_back(plan_indexed(cube(), ball, options).path);
    }
    for (const ToolPath& path : paths) {
        ASSERT_EQ(path.points.size(), paths.front().points.size());
        for (std::size_t k = 0; k < path.points.size(); ++k)
            EXPECT_EQ(path.points[k].location.tip, paths.front().points[k].location.tip);
    }
}

TEST(IndexedPlan, RefusesOptionsOutOfRange)
{
    for (const double height : {0.0, 2.0, -1.0}) {
        IndexedOptions options = coarse({{0, 0, 1}});
        options.scallop_height = height;
        EXPECT_THROW(plan_indexed(cube(), ball, options), DomainError);
    }
    IndexedOptions options = coarse({{0, 0, 1}});
    options.inner_tolerance = 0;
    EXPECT_THROW(plan_indexed(cube(), ball, options), DomainError);
    options = coarse({{0, 0, 1}});
    options.clearance = 0;
    EXPECT_THROW(plan_indexed(cube(), ball, options), DomainError);
    EXPECT_THROW(plan_indexed(cube(), ball, coarse({})), DomainError);
}

}  // namespace
}  // namespace endmill
