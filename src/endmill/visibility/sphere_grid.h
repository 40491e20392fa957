// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

/// \file
/// The sphere of directions, divided into spherical triangles.

namespace endmill {

/// A division of the sphere of directions into spherical triangles, the cells.
/// Source: [KangSuh, section 2]. The paper has 1200 cells and does not describe them; see
/// docs/methods/five-axis-setup.md, section 8.
struct SphereGrid {
    std::string name;             ///< the name that `sphere_grid` read
    std::vector<Vec3> corners;    ///< unit
    std::vector<Triangle> cells;  ///< corner numbers, counter-clockwise seen from outside
    std::vector<Vec3> centres;    ///< unit: normalised sum of the corners of each cell
    std::vector<double> solid_angles_sr;  ///< of each cell
};

/// Makes a grid. Searches break ties by the order of its cells.
///
/// - "hex:F": 12 F^2 cells of a hexagonal bipyramid.
/// - "cube:F": 12 F^2 cells of a cube.
/// - "latlong:NxM": 2 N (M - 1) cells, N around in M bands; N >= 3, M >= 2.
/// - "ico:L": 20 * 4^L cells of an icosahedron.
/// \param name one of these words, with numbers in place of the letters.
/// \throws DomainError for another name, or more than 10^7 cells.
SphereGrid sphere_grid(std::string_view name);

/// The number of cells of `sphere_grid(name)`, without making them.
/// \throws DomainError as `sphere_grid`.
std::size_t sphere_grid_cells(std::string_view name);

}  // namespace endmill
