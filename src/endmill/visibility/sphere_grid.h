// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The sphere of directions cut into spherical triangles. Source: [KangSuh, section 2], who
/// have 1200 of them and do not say which.
struct SphereGrid {
    std::string name;                     ///< as `sphere_grid` reads it
    std::vector<Vec3> corners;            ///< unit
    std::vector<Triangle> cells;          ///< by the numbers of their corners
    std::vector<Vec3> centres;            ///< unit: normalised sums of a cell's corners
    std::vector<double> solid_angles_sr;  ///< of the spherical triangles
};

/// The grid named "hex:F" (12 F^2 cells of a hexagonal bipyramid), "cube:F" (12 F^2 of a cube),
/// "latlong:NxM" (2 N (M - 1), N around, M bands) or "ico:L" (20 4^L of an icosahedron), its
/// cells in an order that decides ties.
/// \throws DomainError for another word, or more than 10^7 cells.
SphereGrid sphere_grid(std::string_view name);

/// How many cells `sphere_grid(name)` has, without making them. Throws like it.
std::size_t sphere_grid_cells(std::string_view name);

}  // namespace endmill
