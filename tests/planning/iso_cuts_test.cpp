// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/iso_cuts.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/planning/linking.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

const Surface& hump()
{
    static const Surface surface =
        test::graph(test::monomial(2, 0, -0.01), {{-20, 20}, {0, 30}}, {2, 3});
    return surface;
}

SurfaceContact on_hump(double u, double v)
{
    return {u, v, {hump().tangents(u, v).point, Vec3::UnitZ()}};
}

struct Seen {
    double from;
    double to;
    double v;
};

std::vector<Seen> cuts_of(const std::vector<Pass>& passes, Parameter along)
{
    std::vector<Seen> seen;
    const ToolPath path = link_passes(passes, BallCutter{1}, {});
    for_each_iso_cut(std::span{&hump(), 1}, path, along, [&](const IsoCut& cut) {
        // The contacts of the move lie on the line, so it is the line of the pass.
        const auto off = [&](double u, const PathPoint& point) {
            return (cut.line.point(u) - point.contact()->contact.point).norm();
        };
        EXPECT_LT(std::max(off(cut.from, cut.start), off(cut.to, cut.end)), 1e-12);
        const Vec3 there = cut.surface.tangents(cut.to, cut.line.v()).point;
        EXPECT_LT((there - cut.line.point(cut.to)).norm(), 1e-12);
        seen.push_back({cut.from, cut.to, cut.line.v()});
    });
    return seen;
}

TEST(ForEachIsoCut, GoesThroughTheCutsOfEveryPassAndNotItsLinks)
{
    const auto seen = cuts_of({{on_hump(0, 0.5), on_hump(0.7, 0.5), on_hump(2, 0.5)},
                               {on_hump(0.2, 1), on_hump(1.9, 1)}},
                              Parameter::U);
    ASSERT_EQ(seen.size(), 3U);
    EXPECT_EQ(seen[0].from, 0);
    EXPECT_EQ(seen[0].to, 0.7);
    EXPECT_EQ(seen[1].to, 2);
    EXPECT_EQ(seen[1].v, 0.5);
    EXPECT_EQ(seen[2].v, 1);
}

TEST(ForEachIsoCut, TurnsASurfaceWhosePassesRunAlongV)
{
    const auto seen = cuts_of({{on_hump(0.5, 0), on_hump(0.5, 3)}}, Parameter::V);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(seen[0].from, 0);
    EXPECT_EQ(seen[0].to, 3);
    EXPECT_EQ(seen[0].v, 0.5);
}

TEST(ForEachIsoCut, VisitsNothingOfAnEmptyPath)
{
    for_each_iso_cut(std::span{&hump(), 1}, {}, Parameter::U,
                     [](const IsoCut&) { FAIL(); });
}

}  // namespace
}  // namespace endmill
