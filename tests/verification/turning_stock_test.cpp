// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_stock.h"

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/verification/detail/closed_form_parts.h"
#include "endmill/verification/verification.h"
#include "turning_paths.h"

namespace endmill {
namespace {

const Block block{{-2, -6, -1}, {22, 6, 4}};

// Passes with a lead that changes, y from -4 to 0 or from 0 to 4, clear of the stock at both
// ends.
ToolPath half_of_passes(const Cutter& cutter, double y, double lead)
{
    ToolPath path = test::plane_passes(
        cutter, {.apart = 2, .count = 3, .lead = {lead, 2 * lead}, .points = 11});
    for (PathPoint& point : path.points)
        point.location.tip.y() += y;
    return path;
}

VerificationTask task_of(const ToolPath& path, const Cutter& cutter, const Part& part)
{
    VerificationTask task{.path = &path, .cutter = cutter, .stock = block};
    task.judged = JudgedPart{.part = &part, .limits = {0.01, 0.15}};
    task.resolution = 0.5;
    task.engine = RemovalEngine::FiveAxis;
    return task;
}

void expect_same(const DexelStock& one, const DexelStock& other)
{
    for (int axis = 0; axis < 3; ++axis) {
        const DexelField& a = one.field(axis);
        const DexelField& b = other.field(axis);
        ASSERT_EQ(a.rows(), b.rows());
        ASSERT_EQ(a.columns(), b.columns());
        for (int row = 0; row < a.rows(); ++row)
            for (int column = 0; column < a.columns(); ++column) {
                EXPECT_TRUE(
                    std::ranges::equal(a.upper(column, row), b.upper(column, row)));
                EXPECT_TRUE(
                    std::ranges::equal(a.lower(column, row), b.lower(column, row)));
            }
    }
}

// The second of two runs gives what one path of both gives, whatever the first one was.
void expect_one_path(const Verification& after, const Verification& before,
                     const Verification& one)
{
    EXPECT_EQ(after.verdict, one.verdict);
    expect_same(std::get<DexelStock>(after.rest), std::get<DexelStock>(one.rest));
    const Deviation& a = after.on_part->deviation;
    const Deviation& b = one.on_part->deviation;
    EXPECT_EQ(a.max_gouge_mm, b.max_gouge_mm);
    EXPECT_EQ(a.gouge_bound_mm, b.gouge_bound_mm);
    EXPECT_EQ(a.max_scallop_mm, b.max_scallop_mm);
    EXPECT_EQ(a.scallop_bound_mm, b.scallop_bound_mm);
    EXPECT_NEAR(after.removal.total + before.removal.total, one.removal.total, 1e-6);
}

ToolPath joined(const ToolPath& first, const ToolPath& second)
{
    ToolPath both = first;
    both.points.insert(both.points.end(), second.points.begin(), second.points.end());
    return both;
}

TEST(TurningStock, SecondRunEqualsOnePathOfBoth)
{
    const Part part = plane_part({20, 0, 0}, {0, 4, 0});
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{4, 1}}) {
        const ToolPath first = half_of_passes(cutter, -2, 0.1);
        const ToolPath second = half_of_passes(cutter, 2, 0.15);
        const ToolPath both = joined(first, second);
        const VerificationTask task = task_of(first, cutter, part);
        const Verification before = verify_path(task);
        const KeptDexels kept{std::get<DexelStock>(before.rest),
                              *turning_history_of_rest(task)};
        VerificationTask next = task_of(second, cutter, part);
        next.stock = &kept;
        const Verification after = verify_path(next);
        expect_one_path(after, before, verify_path(task_of(both, cutter, part)));
        EXPECT_EQ(after.earlier_moves, first.points.size() - 1);
        EXPECT_FALSE(before.earlier_moves);
        // The history of both runs is that of the kept one and of the second path.
        EXPECT_EQ(motion_count(*turning_history_of_rest(next)), both.points.size() - 2);
    }
}

// A head turns the first run; its joint motion is kept exactly.
TEST(TurningStock, RunOfAMachineIsKept)
{
    const Cutter ball = Cutter::ball(5);
    const Part part = plane_part({20, 0, 0}, {0, 4, 0});
    ToolPath first;
    MachineMotion motion;
    motion.setup.machine.configuration = configuration_from_word("W/Bxyzb/T");
    motion.setup.machine.pivot = 50;
    motion.setup.tool_length = 30;
    for (int k = -1; k <= 6; ++k) {
        const RotaryPositions rotary{0.1 * k, 0};
        const Vec3 tip{4.0 * std::max(k, 0), 1, k < 0 ? 30.0 : 0.0};
        motion.positions.push_back(axis_positions(motion.setup, rotary, tip));
        test::add(first, k < 0 ? Move::Rapid : Move::Cut,
                  tool_location(motion.setup, motion.positions.back()));
    }
    first.machine = motion;
    const VerificationTask task = task_of(first, ball, part);
    const Verification before = verify_path(task);
    const KeptDexels kept{std::get<DexelStock>(before.rest),
                          *turning_history_of_rest(task)};
    // Nothing is cut by a second path above the stock.
    ToolPath second;
    for (const double x : {0.0, 10.0})
        test::add(second, x == 0 ? Move::Rapid : Move::Cut, {{x, 0, 9}, {0, 0, 1}});
    VerificationTask next = task_of(second, ball, part);
    next.stock = &kept;
    const Verification after = verify_path(next);
    EXPECT_EQ(after.removal.total, 0);
    EXPECT_EQ(after.on_part->deviation.max_gouge_mm,
              before.on_part->deviation.max_gouge_mm);
    EXPECT_EQ(after.on_part->deviation.max_scallop_mm,
              before.on_part->deviation.max_scallop_mm);
}

// Heights with their moves: as if these moves were the beginning of the path.
TEST(TurningStock, HeightsWithAHistoryAreCutAgain)
{
    const Cutter cutter = Cutter::ball(5);
    const Part part = plane_part({20, 0, 0}, {0, 4, 0});
    ToolPath first = half_of_passes(cutter, -2, 0);
    for (PathPoint& point : first.points)
        point.location.axis = Vec3::UnitZ();
    const ToolPath second = half_of_passes(cutter, 2, 0.15);
    VerificationTask upright = task_of(first, cutter, part);
    upright.engine = RemovalEngine::ThreeAxis;
    const Verification three = verify_path(upright);
    const KeptStock kept{three.heights(), history_of_rest(upright)};
    const Verification five = verify_path(task_of(first, cutter, part));
    VerificationTask next = task_of(second, cutter, part);
    next.stock = &kept;
    expect_one_path(verify_path(next), five,
                    verify_path(task_of(joined(first, second), cutter, part)));
}

// Heights alone: a slot that was cut too deep before is found, as far as they prove it.
TEST(TurningStock, GougeInHeightsWithoutAHistoryIsFound)
{
    const Cutter cutter = Cutter::ball(5);
    const Part part = plane_part({20, 0, 0}, {0, 4, 0});
    HeightStock heights = block_stock(block, 0.5);
    for (int row = 0; row < heights.grid().rows; ++row)
        for (int column = 20; column < 28; ++column)
            heights.set_height(column, row, -0.3);
    const KeptStock kept{heights};
    const ToolPath path = half_of_passes(cutter, 2, 0.15);
    VerificationTask task = task_of(path, cutter, part);
    task.stock = &kept;
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::Gouged);
    ASSERT_TRUE(found.on_part->earlier_gouge);
    EXPECT_NEAR(found.on_part->earlier_gouge->found_mm, 0.3, 1e-9);
    EXPECT_FALSE(turning_history_of_rest(task));
}

TEST(TurningStock, ThreeAxesTakeNoDexels)
{
    const Cutter cutter = Cutter::ball(5);
    const Part part = plane_part({20, 0, 0}, {0, 4, 0});
    const ToolPath path = level_passes(1, std::nullopt);
    const KeptDexels kept{DexelStock{block, 1}, {block, {}}};
    VerificationTask task = task_of(path, cutter, part);
    task.stock = &kept;
    task.engine = RemovalEngine::ThreeAxis;
    EXPECT_THROW(verify_path(task), DomainError);
}

}  // namespace
}  // namespace endmill
