// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/tool_runs.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/verification/verification.h"
#include "finished_plane.h"
#include "tip_path.h"

namespace endmill {
namespace {

const Cutter wide = Cutter::flat(5);
const Cutter narrow = Cutter::ball(2);
constexpr std::size_t first_of_narrow = 3;

// A slot of the wide tool, then one of the narrow tool across it.
ToolPath two_slots()
{
    ToolPath path = test::tip_path({{-20, 0, -2},
                                    {20, 0, -2},
                                    {20, 0, 10},
                                    {0, -20, 10},
                                    {0, -20, -4},
                                    {0, 20, -4}});
    path.points[2].move = path.points[3].move = Move::Rapid;
    return path;
}

const Block block{{-15, -15, -10}, {15, 15, 0}};

VerificationTask slots_task(const ToolPath& path)
{
    VerificationTask task{.path = &path, .cutter = wide, .stock = block};
    task.resolution = 0.5;
    task.changes = {{first_of_narrow, narrow}};
    return task;
}

// Each tool alone on what the other left is the same cut.
TEST(ToolRuns, RemoveWhatTwoPathsRemoveInTurn)
{
    const ToolPath path = two_slots();
    const Verification found = verify_path(slots_task(path));
    EXPECT_EQ(found.verdict, Verdict::NotJudged);

    HeightStock stock = block_stock(block, 0.5);
    const ToolPath before{{path.points.begin(), path.points.begin() + first_of_narrow}};
    const ToolPath after{{path.points.begin() + first_of_narrow, path.points.end()}};
    const Removal first = remove_along(stock, before, wide);
    const Removal second = remove_along(stock, after, narrow);
    EXPECT_DOUBLE_EQ(found.removal.total, first.total + second.total);
    ASSERT_EQ(found.removal.removed.size(), path.points.size());
    EXPECT_EQ(found.removal.removed[1], first.removed[1]);
    EXPECT_EQ(found.removal.removed[5], second.removed[2]);
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column)
            ASSERT_EQ(found.heights().height(column, row), stock.height(column, row));
}

// A slot of a flat cutter through a block has a rectangular section.
TEST(ToolRuns, CutWithTheirOwnCutters)
{
    ToolPath path = two_slots();
    VerificationTask task = slots_task(path);
    task.changes = {{first_of_narrow, Cutter::flat(2)}};
    const Verification found = verify_path(task);
    const double both = 30.0 * 10 * 2 + 30.0 * 4 * 4 - 10.0 * 4 * 2;
    EXPECT_NEAR(found.removal.total, both, 1e-9);
}

TEST(ToolRuns, NumberMovesThroughTheWholePath)
{
    ToolPath path = two_slots();
    path.points[5].move = Move::Rapid;
    const Verification found = verify_path(slots_task(path));
    EXPECT_EQ(found.verdict, Verdict::Collides);
    EXPECT_EQ(found.contacts.rapid_cuts.count, 1U);
    EXPECT_EQ(found.contacts.rapid_cuts.first, 5U);
}

TEST(ToolRuns, CollideWithTheHolderOfTheirOwnTool)
{
    const ToolPath path = two_slots();
    VerificationTask task = slots_task(path);
    task.changes = {{first_of_narrow, narrow, {{20, 3, 30}}}};
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::Collides);
    EXPECT_EQ(found.contacts.collisions.first, 4U);
    EXPECT_NEAR(found.contacts.collisions.deepest, 1, 1e-9);
}

// The finishing path of the ball stays clean if another tool has cut above it before.
TEST(ToolRuns, AreJudgedTogether)
{
    ToolPath path = test::finishing_path(2);
    const std::size_t finishing = path.points.size();
    ToolPath rough = path;
    for (PathPoint& point : rough.points)
        point.location.tip.z() += 0.4;
    path.points.insert(path.points.begin(), rough.points.begin(), rough.points.end());
    VerificationTask task = test::task_of(path, &test::finished_plane);
    task.cutter = Cutter::flat(3);
    task.changes = {{finishing, Cutter::ball(5)}};
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::Clean);
    const auto& deepest = found.on_part->deviation.highest;
    ASSERT_TRUE(deepest);
    EXPECT_GE(deepest->sweep, static_cast<int>(finishing));
    // Passes 2 mm apart of a ball of radius 1 leave ridges of 1 mm, cut down to 0.4.
    task.changes = {{finishing, Cutter::ball(1)}};
    EXPECT_NE(verify_path(task).verdict, Verdict::Clean);
    EXPECT_EQ(history_of_rest(task)->runs.size(), 2U);
}

TEST(ToolRuns, MustAscendWithinThePath)
{
    const ToolPath path = two_slots();
    VerificationTask task = slots_task(path);
    for (const std::vector<ToolChange>& changes : {std::vector<ToolChange>{{0, narrow}},
                                                   {{6, narrow}},
                                                   {{3, narrow}, {3, wide}}}) {
        task.changes = changes;
        EXPECT_THROW(verify_path(task), DomainError);
    }
}

}  // namespace
}  // namespace endmill
