// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/offset/detail/offset_grid.h"

namespace endmill {

/// A side of a grid. Sides run counter-clockwise around the grid as seen from the tool.
struct GridSide {
    static constexpr std::int32_t none = -1;

    /// Numbers of the vertices along the side.
    std::vector<std::int32_t> vertices;
    std::vector<Vec3> points;  ///< contact points of the vertices, mm
    /// direction of the side at each vertex, not unit; zero where unknown
    std::vector<Vec3> along;
    /// number of the side with the same points in reverse order
    std::int32_t mate = none;
    /// all points are equal: the side is no border and has no mate
    bool is_collapsed = false;

    /// Whether the side is part of the border of the part.
    bool is_border() const { return mate == none && !is_collapsed; }
};

/// The four sides of each grid; side k of grid n is at index 4 n + k. Two sides are mates
/// if they have the same points, to `same_point` mm, in opposite order.
/// \param surfaces the part.
/// \param grids its grids.
/// \param same_point in mm.
std::vector<GridSide> grid_sides(std::span<const Surface> surfaces,
                                 std::span<const OffsetGrid> grids, double same_point);

/// The side of the same grid that begins where side `number` ends.
std::int32_t next_side(std::int32_t number);
/// the side that ends where side `number` begins
std::int32_t previous_side(std::int32_t number);

}  // namespace endmill
