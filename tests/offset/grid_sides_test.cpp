// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/grid_sides.h"

#include <gtest/gtest.h>

#include "offset_parts.h"

namespace endmill {
namespace {

std::vector<GridSide> sides_of(const std::vector<Surface>& part, int lines)
{
    const std::vector<double> tool_sides(part.size(), 1);
    return grid_sides(part, offset_grids(part, tool_sides, lines), 1e-6);
}

// Four squares around a point: eight inner sides in pairs, and eight sides on the border.
TEST(GridSides, OfFourFacetsHaveMatesInside)
{
    const auto sides = sides_of(test::pyramid(10, 0.3), 4);
    ASSERT_EQ(sides.size(), 16U);
    int borders = 0;
    for (std::int32_t number = 0; number < 16; ++number) {
        const GridSide& side = sides[number];
        EXPECT_FALSE(side.is_collapsed);
        if (side.is_border()) {
            ++borders;
            continue;
        }
        const GridSide& mate = sides[side.mate];
        EXPECT_EQ(mate.mate, number);
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_LE((side.points[k] - mate.points[3 - k]).norm(), 1e-14);
            EXPECT_LT(side.along[k].dot(mate.along[3 - k]), 0);
        }
    }
    EXPECT_EQ(borders, 8);
}

TEST(GridSides, RunAlongTheBorder)
{
    for (const GridSide& side : sides_of({test::random_surface(2)}, 9)) {
        ASSERT_EQ(side.points.size(), 9U);
        for (std::size_t k = 0; k + 1 < 9; ++k) {
            const Vec3 step = side.points[k + 1] - side.points[k];
            EXPECT_GT(step.dot(side.along[k] + side.along[k + 1]), 0);
        }
    }
}

// Sides with different grid lines are borders. A side that is a point is neither border
// nor mate.
TEST(GridSides, ThatDoNotMatchAreBorders)
{
    const auto level = [](double, double) { return 0.0; };
    const std::vector<Surface> part{test::facet({{0, 1}, {0, 1}}, level),
                                    test::facet({{1, 2}, {0, 2}}, level)};
    for (const GridSide& side : sides_of(part, 3))
        EXPECT_TRUE(side.is_border());
    const std::vector<Vec3> net{{0, 0, 0}, {0, 0, 0}, {10, -5, 3}, {10, 5, 3}};
    const auto sides = sides_of({Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}}}, 3);
    EXPECT_TRUE(sides[0].is_collapsed);
    EXPECT_FALSE(sides[0].is_border());
    EXPECT_TRUE(sides[2].is_border());
}

TEST(GridSides, FollowEachOtherRoundASheet)
{
    EXPECT_EQ(next_side(7), 4);
    EXPECT_EQ(next_side(4), 5);
    EXPECT_EQ(previous_side(4), 7);
    EXPECT_EQ(previous_side(10), 9);
}

}  // namespace
}  // namespace endmill
