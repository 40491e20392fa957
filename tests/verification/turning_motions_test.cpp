// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_motions.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "turning_paths.h"

namespace endmill {
namespace {

ToolPath turning_path()
{
    ToolPath path;
    for (int k = 0; k < 4; ++k)
        test::add(path, k == 0 ? Move::Rapid : Move::Cut,
                  {{2.0 * k, 0, 0}, {std::sin(0.1 * k), 0, std::cos(0.1 * k)}});
    return path;
}

TEST(TurningMotions, PiecesFollowEachOtherAndTurnLittle)
{
    const ToolPath path = turning_path();
    const Cutter ball = Cutter::ball(3);
    const std::vector<ToolCylinder> body{{8, 10, 20}, {20, 20, 40}};
    const ToolRuns runs{{path, ball, body, {}}};
    const TurningMotions motions = motions_along(path, runs.list());
    ASSERT_GT(motions.cutters.size(), 3U);
    EXPECT_EQ(motions.bodies.size(), 2 * motions.cutters.size());
    const ToolFrame* before = nullptr;
    for (const ToolPiece& piece : motions.cutters) {
        EXPECT_LE(piece.motion.turn(), 0.03 + 1e-12);
        if (before) {
            EXPECT_LE((before->tip - piece.motion.from().tip).norm(), 1e-12);
            EXPECT_LE((before->axes.col(2) - piece.motion.from().axes.col(2)).norm(),
                      1e-12);
        }
        before = &piece.motion.to();
    }
    EXPECT_EQ(motions.cutters.front().point, 1);
    EXPECT_EQ(motions.cutters.back().point, 3);
}

TEST(TurningMotions, EarlierRunHasTheMotionsOfItsPath)
{
    const ToolPath path = turning_path();
    const Cutter ball = Cutter::ball(3);
    const ToolRuns runs{{path, ball, {}, {}}};
    const std::vector<ToolPiece> own = motions_along(path, runs.list()).cutters;
    const TurningHistory history{
        {}, {turning_run_along(path, 0, path.points.size(), CuttingBody{ball}, false)}};
    const std::vector<ToolPiece> earlier = earlier_motions(history, 7);
    ASSERT_EQ(earlier.size(), own.size());
    EXPECT_EQ(motion_count(history), path.points.size() - 1);
    for (std::size_t k = 0; k < own.size(); ++k) {
        EXPECT_EQ(earlier[k].point, 7);
        EXPECT_EQ(earlier[k].order, own[k].order);
        EXPECT_EQ(earlier[k].motion.from().tip, own[k].motion.from().tip);
        EXPECT_EQ(earlier[k].motion.to().axes, own[k].motion.to().axes);
    }
}

TEST(TurningMotions, OppositeAxesOfAnEarlierRunAreRefused)
{
    const TurningHistory history{{},
                                 {{CuttingBody{Cutter::ball(1)},
                                   true,
                                   {{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, -1}}}}}};
    EXPECT_THROW(earlier_motions(history, 0), GeometryError);
}

}  // namespace
}  // namespace endmill
