// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/offset_grid.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

std::vector<OffsetGrid> sheets_of(const Surface& surface, int lines, double side = 1)
{
    return offset_grids({&surface, 1}, std::vector{side}, lines);
}

TEST(OffsetGrid, OfASmoothSurfaceIsOneWithEvenLines)
{
    const auto grids = sheets_of(test::plane(30, 20, {3, 2}), 5);
    ASSERT_EQ(grids.size(), 1U);
    ASSERT_EQ(grids[0].columns(), 5);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(grids[0].u[i].parameter, 3 * i / 4.0);
        EXPECT_EQ(grids[0].v[i].parameter, 2 * i / 4.0);
    }
    EXPECT_EQ(grids[0].vertex(2, 3), 17);
}

// Two planes meet in a crease at u = 1. Both grids contain that line, each evaluated from
// its own patch, whether or not it is one of the equidistant lines.
TEST(OffsetGrid, IsPartedAtACrease)
{
    const Surface valley = test::valley(20, 10, 0.5);
    for (const int lines : {4, 5}) {
        const auto grids = sheets_of(valley, lines);
        ASSERT_EQ(grids.size(), 2U);
        const std::int32_t last = grids[0].columns() - 1;
        EXPECT_EQ(grids[0].u[last].parameter, 1);
        EXPECT_EQ(grids[1].u[0].parameter, 1);
        EXPECT_EQ(grids[0].columns(), 3);
        EXPECT_EQ(grids[1].first, grids[0].columns() * grids[0].rows());
        const auto normal = [&](const OffsetGrid& grid, int i) {
            return normal_at(grid, valley, i, 0, tangents_at(grid, valley, i, 0));
        };
        EXPECT_LE((normal(grids[0], last) - Vec3{0.5, 0, 1}.normalized()).norm(), 1e-14);
        EXPECT_LE((normal(grids[1], 0) - Vec3{-0.5, 0, 1}.normalized()).norm(), 1e-14);
    }
}

// Sides follow each other counter-clockwise as seen from the tool, in a mirrored
// parametrisation too.
TEST(OffsetGrid, SidesGoRoundCounterClockwise)
{
    const Surface plain = test::parallelogram({4, 0, 0}, {0, 3, 0});
    const Surface mirrored = test::parallelogram({0, 3, 0}, {4, 0, 0});
    for (const auto& [surface, side] : {std::pair{plain, 1.0}, {mirrored, -1.0}}) {
        const auto grids = sheets_of(surface, 3, side);
        double area = 0;
        Vec3 last = Vec3::Zero();
        int places = 0;
        for (int number = 0; number < 4; ++number)
            for (const auto& [i, j] : grids[0].side_places(number)) {
                const Vec3 point = tangents_at(grids[0], surface, i, j).point;
                area += (last.x() * point.y() - last.y() * point.x()) / 2;
                last = point;
                ++places;
            }
        EXPECT_NEAR(area, 12, 1e-12);
        EXPECT_EQ(places, 12);
        const Vec3 normal =
            normal_at(grids[0], surface, 1, 1, tangents_at(grids[0], surface, 1, 1));
        EXPECT_LE((normal - Vec3::UnitZ()).norm(), 1e-15);
    }
}

// At a collapsed edge the normal is the limit; a surface that is a line has none.
TEST(OffsetGrid, TakesTheLimitOfTheNormalAtAPole)
{
    const std::vector<Vec3> net{{0, 0, 0}, {0, 0, 0}, {10, -5, 3}, {10, 5, 3}};
    const Surface triangle{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}};
    const auto grids = sheets_of(triangle, 3);
    const auto normal = [&](int i, int j) {
        return normal_at(grids[0], triangle, i, j, tangents_at(grids[0], triangle, i, j));
    };
    EXPECT_LE((normal(1, 0) - normal(1, 2)).norm(), 1e-15);
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const Surface line{{0, 1}, {0, 1}, {BezierPatch{1, 1, flat}}};
    const auto lines = sheets_of(line, 3);
    EXPECT_THROW(normal_at(lines[0], line, 1, 1, tangents_at(lines[0], line, 1, 1)),
                 GeometryError);
}

}  // namespace
}  // namespace endmill
