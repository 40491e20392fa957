// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// The box of all triangles.
/// \throws GeometryError if the mesh has none.
Block mesh_box(const TriangleMesh& mesh);

/// The stock of a closed mesh: over each cell's centre the highest place of the mesh; no
/// material where the mesh is not below the centre. Its box is that of the mesh. What a
/// height cannot say is taken for full: hollows that are open sideways or downwards.
/// \throws DomainError unless 0 < pitch.
/// \throws GeometryError if the mesh has no triangle, or is not closed: an edge belongs to
///         an odd number of triangles.
/// \throws LimitError as `grid_over`.
HeightStock mesh_stock(const TriangleMesh& mesh, double pitch);

/// The most memory in bytes a cell that `stock_mesh` takes while the mesh is made and
/// turned into a binary STL file: two points and at most five triangles a cell, in vectors
/// that double (324) or beside 50 bytes a triangle (466), and a number for each.
inline constexpr double mesh_bytes_per_cell = 470;

/// The stock as a closed mesh, to look at or to measure. Its top has a point at the height
/// over the centre of each cell, and squares of two triangles between four neighbours that
/// all have material; under them is a plane bottom, around them are upright walls. So it
/// ends half a pitch before the outermost cells, and walls of material that are one cell
/// thin are missing. Pieces may touch along upright edges.
/// \throws LimitError if it has more than 2^31 - 1 points or triangles.
TriangleMesh stock_mesh(const HeightStock& stock);

}  // namespace endmill
