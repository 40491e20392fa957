// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/stock/dexel_stock.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Returns the bounding box of all triangles.
/// \throws GeometryError if the mesh has none.
Block mesh_box(const TriangleMesh& mesh);

/// Returns the stock of a closed mesh. The height of a cell is the highest point of the
/// mesh on the vertical line through the cell's centre; a line that misses the mesh gets
/// no material. The grid covers the box of the mesh. A height field cannot represent
/// hollows that are open sideways or downwards: they are filled.
/// \throws DomainError unless 0 < pitch.
/// \throws GeometryError if the mesh has no triangle or is not closed (an edge belongs to
///         an odd number of triangles).
/// \throws LimitError if the grid has more than 2^31 - 1 columns or rows.
HeightStock mesh_stock(const TriangleMesh& mesh, double pitch);

/// Greatest memory in bytes per cell while `stock_mesh` makes the mesh and a binary STL
/// file is made of it. A cell has two points, at most five triangles and one number.
/// While they grow by doubling, the vectors of points and triangles take 324 bytes. The
/// file takes 50 bytes per triangle more, which gives 466 bytes in all.
inline constexpr double mesh_bytes_per_cell = 470;

/// Returns the stock as a closed mesh, for viewing or measuring.
///
/// The top has one point over the centre of each cell and two triangles between four
/// neighbours that all have material. A plane bottom and upright walls close it. The mesh
/// therefore ends half a pitch inside the outermost cells, and walls of material that are
/// one cell thick are missing. Pieces may touch along upright edges.
/// \throws LimitError if the mesh has more than 2^31 - 1 points or triangles.
TriangleMesh stock_mesh(const HeightStock& stock);

/// Greatest memory in bytes per ray while `stock_mesh` makes the mesh of a stock of dexels
/// and a binary STL file is made of it. A ray with one interval crosses the surface twice;
/// each crossing has two triangles and about one point. While they grow by doubling, the
/// vectors take 144 bytes per crossing, and the file 100.
inline constexpr double mesh_bytes_per_ray = 490;

/// Returns the stock as a closed mesh. It is that of the upper set, which contains all
/// material on the rays.
///
/// The rays of the three fields meet in nodes. Between two neighbouring nodes of which one
/// is in the material the surface crosses the ray through both. The mesh has a vertex in each
/// cube between eight nodes, where the tangent planes of its crossings meet, so that edges
/// and corners of the stock stay sharp. The normals of these planes follow from the
/// neighbouring rays. Features thinner than a pitch may be missing; where two parts of the
/// surface share a cube, they share its vertex. The volume is accurate to the square of the
/// pitch.
/// Source: [JuLosassoSchaeferWarren, eq. (1)].
/// \throws LimitError if the mesh has more than 2^31 - 1 points or triangles.
TriangleMesh stock_mesh(const DexelStock& stock);

}  // namespace endmill
