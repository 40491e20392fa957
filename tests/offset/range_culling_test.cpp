// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/range_culling.h"

#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr int lines = 6;
constexpr double size_x = 50;
constexpr double size_y = 20;

// The offset of a level rectangle is the rectangle at the ball's radius.
OffsetMesh rectangle_offset()
{
    const std::vector part{test::plane(size_x, size_y)};
    return offset_mesh(part, Cutter::ball(3),
                       {.grid_lines = lines, .boundary = BoundaryContact::None});
}

// t is -x sin a + y cos a, so that a piece of dx by dy spans dx sin a + dy cos a.
TEST(RangeCulling, SpansThePiecesOfARectangle)
{
    const double a = 0.3;
    const DriveFrame frame{Angle::radians(a)};
    const double dx = size_x / (lines - 1);
    const double dy = size_y / (lines - 1);
    const auto strips = strip_ranges(rectangle_offset(), frame, lines);
    ASSERT_EQ(strips.size(), lines - 1U);
    for (std::size_t k = 0; k < strips.size(); ++k) {
        EXPECT_NEAR(strips[k].high, size_y * std::cos(a) - dx * double(k) * std::sin(a),
                    1e-12);
        EXPECT_NEAR(strips[k].length(), dx * std::sin(a) + size_y * std::cos(a), 1e-12);
    }
    const auto cells = cell_ranges(rectangle_offset(), frame);
    ASSERT_EQ(cells.size(), (lines - 1U) * (lines - 1U));
    for (const Interval& cell : cells)
        EXPECT_NEAR(cell.length(), dx * std::sin(a) + dy * std::cos(a), 1e-12);
}

// Along a feed in y the strips touch end to end. Each plane then meets exactly one strip
// and one cell of each row.
TEST(RangeCulling, LeavesEachPlaneOneOfSeveralAdjacentStrips)
{
    const DriveFrame frame{Angle::degrees(90)};
    const auto planes = drive_planes(frame, {-size_x, 0}, 17).positions;
    const OffsetMesh offset = rectangle_offset();
    EXPECT_EQ(culled_pairs(strip_ranges(offset, frame, lines), planes), 17U);
    EXPECT_EQ(culled_pairs(cell_ranges(offset, frame), planes), 17U * (lines - 1));
}

// Along a feed in x every strip has the whole range, so that culling saves nothing.
TEST(RangeCulling, SavesNothingAlongTheStrips)
{
    const DriveFrame frame{Angle::degrees(0)};
    const auto planes = drive_planes(frame, {0, size_y}, 17).positions;
    const OffsetMesh offset = rectangle_offset();
    EXPECT_EQ(culled_pairs(strip_ranges(offset, frame, lines), planes),
              17U * (lines - 1));
}

// A crossed triangle has vertices on both sides, so that its cell is never culled.
TEST(RangeCulling, LeavesEveryCrossedTriangle)
{
    const std::vector part{test::saddle(15, 20)};
    const OffsetMesh offset = offset_mesh(
        part, Cutter::ball(4), {.grid_lines = 12, .boundary = BoundaryContact::None});
    for (const double degrees : {0.0, 20.0, 71.0}) {
        const DriveFrame frame{Angle::degrees(degrees)};
        const DrivePlanes planes = drive_planes(frame, extent_across(part, frame), 13);
        std::size_t crossed = 0;
        for (const PlaneSection& section : slice(offset.mesh, planes))
            crossed += section.crossed_triangles;
        const std::size_t left =
            2 * culled_pairs(cell_ranges(offset, frame), planes.positions);
        EXPECT_GE(left, crossed);
        EXPECT_LE(left, 2 * crossed);  // at least one triangle of such a cell is crossed
    }
}

TEST(RangeCulling, CountsTheLowerEndOnly)
{
    const std::vector<Interval> ranges{{0, 1}, {1, 2}, {1, 1}};
    const std::vector<double> planes{0, 1, 2};
    EXPECT_EQ(culled_pairs(ranges, planes), 2U);
    EXPECT_EQ(culled_pairs({}, planes), 0U);
}

}  // namespace
}  // namespace endmill
