// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/offset/detail/offset_sheet.h"

namespace endmill {

/// A side of a sheet, counter-clockwise about it seen from the tool.
struct SheetSide {
    static constexpr std::int32_t none = -1;

    std::vector<std::int32_t> vertices;
    std::vector<Vec3> points;  ///< of contact, mm
    std::vector<Vec3> along;   ///< its direction there, not unit; zero where unknown
    std::int32_t mate = none;  ///< number of the side that has the same points, backwards
    bool is_collapsed = false;  ///< all its points are one: no border, and no mate

    bool is_border() const { return mate == none && !is_collapsed; }
};

/// The four sides of each sheet, side k of sheet n at [4 n + k]. Two are mates if they
/// have as many points and these are the same to `same_point` mm, in opposite order.
std::vector<SheetSide> sheet_sides(std::span<const Surface> surfaces,
                                   std::span<const OffsetSheet> sheets,
                                   double same_point);

/// The side of the same sheet that begins where side `number` ends, and the one that ends
/// where it begins.
std::int32_t side_behind(std::int32_t number);
std::int32_t side_before(std::int32_t number);  ///< see side_behind

}  // namespace endmill
