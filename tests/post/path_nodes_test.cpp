// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/path_nodes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "five_axis.h"

namespace endmill {
namespace {

using test::direction;
using test::part_on;
using test::path_through;

// Between nodes no axis turns by 90 degrees, however close the path comes to the pole.
TEST(PathNodes, KeepTheTurnsBetweenThemSmall)
{
    test::Random random{61};
    for (const std::string& word : test::valid_words()) {
        const PartOnMachine setup = part_on(word);
        for (int k = 0; k < 40; ++k) {
            const Vec3 first = test::random_vector(random, 1).normalized();
            const Vec3 second = test::random_vector(random, 1).normalized();
            if (angle_between(first, second) > test::rad(179))
                continue;
            const PathNodes found = path_nodes(
                path_through({{{0, 0, 0}, first}, {{9, 0, 0}, second}}), setup, {});
            for (std::size_t i = 1; i < found.nodes.size(); ++i)
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    const double turn = found.nodes[i].solutions[0][axis] -
                                        found.nodes[i - 1].solutions[0][axis];
                    EXPECT_LE(std::abs(std::remainder(turn, 2 * std::numbers::pi)),
                              test::rad(90) + 1e-9)
                        << word;
                }
            EXPECT_TRUE(found.nodes.back().is_row_end);
            EXPECT_EQ(found.nodes.back().row, 1U);
        }
    }
}

// Nodes are on the path: the tip on the line, the axis on the great arc, evenly.
TEST(PathNodes, AreOnThePath)
{
    const PartOnMachine setup = part_on("caB");
    const Vec3 from = direction(setup, 50, 10);
    const Vec3 to = direction(setup, 60, 170);
    const PathNodes found =
        path_nodes(path_through({{{0, 0, 0}, from}, {{10, 20, 0}, to}}), setup, {});
    ASSERT_GT(found.nodes.size(), 2U);
    for (const PathNode& node : found.nodes) {
        const double u = node.pose.tip.x() / 10;
        EXPECT_NEAR(node.pose.tip.y(), 20 * u, 1e-14);
        EXPECT_LT((node.pose.axis - axis_on_arc(from, to, u)).norm(), 1e-14);
    }
}

// In the cone the axis becomes the pole, and the reference point stays.
TEST(PathNodes, TakeThePoleAndKeepTheReferencePoint)
{
    const PartOnMachine setup = part_on("caB");
    const MachinePathOptions options{.cutter = Cutter{5, 2},
                                     .singular = SingularRule::Turn,
                                     .singular_cone = Angle::degrees(1)};
    const CutterLocation pose{{1, 2, 3}, direction(setup, 0.5, 70)};
    const PathNodes found = path_nodes(path_through({pose}), setup, options);
    EXPECT_EQ(found.singular_points, 1U);
    const CutterLocation& node = found.nodes.front().pose;
    EXPECT_EQ(node.axis, Vec3(0, 0, 1));
    EXPECT_LT((node.tip + 2 * node.axis - pose.tip - 2 * pose.axis).norm(), 1e-15);
    EXPECT_TRUE(found.nodes.front().is_singular());
}

// In a run along the pole the first axis keeps its position until the last node.
TEST(SearchPoses, TurnAtTheEndOfARunInThePole)
{
    const PartOnMachine setup = part_on("Bca");
    const ToolPath path = path_through({{{0, 0, 0}, direction(setup, 20, 30)},
                                        {{1, 0, 0}, {0, 0, 1}},
                                        {{2, 0, 0}, {0, 0, 1}},
                                        {{3, 0, 0}, direction(setup, 20, 80)}});
    const PathNodes found = path_nodes(path, setup, {});
    ASSERT_EQ(found.nodes.size(), 4U);
    const std::vector<SearchPose> poses = search_poses(found.nodes, path, {}, false);
    EXPECT_NEAR(poses[1].arrival[0][0], test::rad(30), 1e-12);
    EXPECT_NEAR(poses[1].departure[0][0], test::rad(30), 1e-12);
    EXPECT_NEAR(poses[2].arrival[0][0], test::rad(30), 1e-12);
    EXPECT_NEAR(poses[2].departure[0][0], test::rad(80), 1e-12);
    EXPECT_EQ(poses[1].turn, PoseTurn::None);
    EXPECT_EQ(poses[2].turn, PoseTurn::Free);
    EXPECT_EQ(search_poses(found.nodes, path, {}, true)[1].turn, PoseTurn::Retract);
}

TEST(SearchPoses, MayTurnBetweenHighRapids)
{
    const PartOnMachine setup = part_on("Bca");
    const Vec3 axis = direction(setup, 20, 30);
    ToolPath path = path_through(
        {{{0, 0, 0}, axis}, {{0, 0, 50}, axis}, {{9, 0, 50}, axis}, {{9, 0, 0}, axis}});
    path.points[1].move = path.points[2].move = Move::Rapid;
    const PathNodes found = path_nodes(path, setup, {});
    const MachinePathOptions options{.free_height = 40};
    const auto poses = search_poses(found.nodes, path, options, false);
    EXPECT_EQ(poses[1].turn, PoseTurn::Free);
    EXPECT_EQ(poses[2].turn, PoseTurn::None);  // the next move is at feed
    EXPECT_EQ(search_poses(found.nodes, path, {}, false)[1].turn, PoseTurn::None);
}

}  // namespace
}  // namespace endmill
