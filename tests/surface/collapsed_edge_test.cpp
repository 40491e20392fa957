// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/collapsed_edge.h"

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr Parameter parameters[] = {Parameter::U, Parameter::V};

// An irregular net with one edge contracted around `pole` to `size` mm.
BezierPatch patch_with_edge(Parameter parameter, int edge, const Vec3& pole, double size)
{
    std::vector<Vec3> net = test::random_net(1, {1, 1}, 3);
    for (int k = 0; k < 4; ++k) {
        const int line = 3 * edge;
        const int place = parameter == Parameter::U ? 4 * k + line : 4 * line + k;
        net[place] = pole + Vec3{k == 1 ? size : 0, 0, k == 2 ? size : 0};
    }
    return BezierPatch{net};
}

TEST(CollapsedEdge, HasAllItsPointsInOnePlace)
{
    for (const Vec3& pole : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}})
        for (const Parameter parameter : parameters)
            for (const int edge : {0, 1}) {
                const BezierPatch patch = patch_with_edge(parameter, edge, pole, 0);
                for (const Parameter other : parameters)
                    for (const int other_edge : {0, 1})
                        EXPECT_EQ(is_collapsed(patch, other, other_edge),
                                  other == parameter && other_edge == edge);
            }
}

TEST(CollapsedEdge, MayBeOffByRoundingButNotByMore)
{
    for (const Parameter parameter : parameters) {
        const Vec3 pole{1, 2, 3};
        EXPECT_TRUE(
            is_collapsed(patch_with_edge(parameter, 1, pole, 2e-12), parameter, 1));
        EXPECT_FALSE(
            is_collapsed(patch_with_edge(parameter, 1, pole, 2e-9), parameter, 1));
    }
}

TEST(CollapsedEdge, IsNotAnEdgeThatReturnsToItsStart)
{
    std::vector<Vec3> net = test::random_net(2, {1, 1}, 3);
    net[3] = net[0];  // the edge v = 0 becomes a loop
    EXPECT_FALSE(is_collapsed(BezierPatch{net}, Parameter::V, 0));
}

TEST(CollapsedEdge, IsEveryEdgeOfAPoint)
{
    const BezierPatch point{std::vector<Vec3>(16, Vec3{1, 2, 3})};
    for (const Parameter parameter : parameters)
        for (const int edge : {0, 1})
            EXPECT_TRUE(is_collapsed(point, parameter, edge));
}

}  // namespace
}  // namespace endmill
