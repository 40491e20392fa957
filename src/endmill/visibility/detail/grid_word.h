// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace endmill {

/// The shapes from which a grid of the sphere is made.
enum class GridKind {
    Hex,      ///< hexagonal bipyramid
    Cube,     ///< cube
    LatLong,  ///< parallels and meridians
    Ico       ///< icosahedron
};

/// The name of a sphere grid, parsed.
struct GridWord {
    GridKind kind;
    int fineness;      ///< hex, cube: F >= 1; latlong: N >= 3; ico: L >= 0
    int bands = 0;     ///< latlong: M >= 2; else 0
    double cells = 0;  ///< number of cells, an integer from 1 to 10^7
};

/// Parses "hex:F", "cube:F", "latlong:NxM" or "ico:L".
/// \throws DomainError for another name, or more than 10^7 cells.
GridWord grid_word(std::string_view name);

}  // namespace endmill
