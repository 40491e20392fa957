// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/tool_bins.h"

#include <set>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

struct Item {
    Vec3 point;
    double size;
};

std::vector<Item> random_items(int count, test::Random& random)
{
    std::vector<Item> items;
    for (int k = 0; k < count; ++k) {
        const double x = random.uniform(-20, 20);
        const double y = random.uniform(-10, 10);
        const Vec3 point{x, y, random.uniform(-5, 5)};
        items.push_back({point, random.uniform(0, 0.8)});
    }
    return items;
}

TEST(ToolBins, FindTheSameItemsAsASearchOfAll)
{
    test::Random random{1};
    for (const CoveringTool tool_kind :
         {CoveringTool::BallAndFlank, CoveringTool::Ball}) {
        BoundProblem problem{BallCutter{3}, 0.1};
        problem.tool = tool_kind;
        for (const int count : {0, 1, 2000}) {
            const ToolBins<Item> bins{random_items(count, random), 3};
            for (int k = 0; k < 50; ++k) {
                const double x = random.uniform(-25, 25);
                const ToolReach tool{problem, {x, random.uniform(-12, 12), 1}};
                std::set<std::uint32_t> near;
                std::set<std::uint32_t> at_boundary;
                bins.visit_near(tool, 3.5, [&](std::uint32_t number, const Vec3& away) {
                    EXPECT_EQ(away, tool.from_nearest(bins.items()[number].point));
                    return near.insert(number).second;
                });
                bins.visit_boundary(tool, [&](std::uint32_t number) {
                    EXPECT_TRUE(at_boundary.insert(number).second);
                });
                for (std::uint32_t item = 0; item < bins.items().size(); ++item) {
                    const double excess = tool.excess(bins.items()[item].point);
                    EXPECT_EQ(near.contains(item), excess + 3 <= 3.5);
                    EXPECT_EQ(at_boundary.contains(item),
                              std::abs(excess) <= bins.items()[item].size);
                }
            }
        }
    }
}

TEST(ToolBins, EndASearchThatIsToldTo)
{
    test::Random random{2};
    const BoundProblem problem{BallCutter{3}, 0.1};
    const ToolBins<Item> bins{random_items(1000, random), 3};
    int visits = 0;
    bins.visit_near(ToolReach{problem, {0, 0, 0}}, 100,
                    [&](std::uint32_t, const Vec3&) { return ++visits < 7; });
    EXPECT_EQ(visits, 7);
}

}  // namespace
}  // namespace endmill
