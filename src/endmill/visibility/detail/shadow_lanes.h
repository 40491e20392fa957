// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "endmill/core/detail/lanes.h"
#include "endmill/visibility/detail/point_cells.h"

namespace endmill {

/// A number for each of as many facets as are dealt with at once.
using EightFloats = std::array<float, float_lanes>;

/// Eight facets as seen along a direction, and what decides which points lie in their shadows.
/// Edge functions and depth are about the first corner and in units of their largest error:
/// positive is inside or below, and what is beyond 1 is certain.
struct alignas(32) EightShadows {
    std::array<std::int32_t, float_lanes> facet{};       ///< their numbers
    std::array<std::array<EightFloats, 3>, 3> corner{};  ///< [corner][axis], within 1

    std::array<float, 2> low{};   ///< of x and y of the points that may be covered
    std::array<float, 2> high{};  ///< of x and y of the points that may be covered
    float highest = 0;            ///< z of the points that may be covered
    std::array<std::array<EightFloats, 2>, 3> side{};  ///< edge functions: by dx and dy
    EightFloats second_offset{};                       ///< of that of side 1
    std::array<EightFloats, 3> depth{};                ///< by dx, dy and dz
    EightFloats low_dz{};                              ///< dz counts within this
    EightFloats high_dz{};                             ///< and this
    EightFloats facing{};      ///< 0 or less: which way is in doubt
    bool has_edge_on = false;  ///< that is so of some facet
};

/// A point that a facet may darken.
struct ShadowDoubt {
    std::uint32_t place;  ///< of the point
    std::int32_t facet;   ///< its number
};

/// What is found of points.
struct Darkness {
    /// Of each block: bit k is set if the point in lane k lies in a shadow.
    std::vector<std::uint8_t> dark_lanes;
    std::vector<ShadowDoubt> doubts;  ///< to be decided by exact arithmetic

    /// Whether the point in a place is found to be dark.
    bool is_dark(std::size_t place) const
    {
        return (dark_lanes[place / PointBlock::size] >> (place % PointBlock::size) &
                1U) != 0;
    }
};

/// Fills in what follows from the corners.
/// \param accuracy of the coordinates of corners and points, at least 2^-25.
void prepare_shadows(EightShadows& shadows, float accuracy);

/// Marks what certainly lies in the shadows and notes what may, but for the facets' own
/// points. \pre the shadows are prepared, `darkness` has a byte for each block.
void darken(const EightShadows& shadows, const PointCells& cells, Darkness& darkness);

}  // namespace endmill
