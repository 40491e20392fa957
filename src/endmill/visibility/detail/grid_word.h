// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace endmill {

/// The shapes that the sphere is cut from.
enum class GridKind { Hex, Cube, LatLong, Ico };

/// A name of a sphere grid, read.
struct GridWord {
    GridKind kind;
    int fineness;   ///< hex, cube: F from 1; latlong: cells around, from 3; ico: L from 0
    int bands = 0;  ///< latlong: from 2
    double cells = 0;  ///< how many the grid has, a whole number from 1 to 10^7
};

/// Reads "hex:F", "cube:F", "latlong:NxM" or "ico:L".
/// \throws DomainError for another word, or more than 10^7 cells.
GridWord grid_word(std::string_view name);

}  // namespace endmill
