// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/detail/raw_mesh.h"
#include "endmill/files/mesh_file.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The mesh of a Wavefront OBJ file: statements `v` and `f`, corners written as v, v/vt,
/// v//vn or v/vt/vn, counted from 1, or from -1 backwards. A face names points above it.
/// Faces of more than three corners are split (`fan_corner`). Numbers after z (a weight,
/// a colour), texture, normals, groups, materials, points, lines and display attributes
/// are ignored.
/// \throws FormatError E_OBJ_SYNTAX for what is no OBJ, and for free-form curves and
///         surfaces; E_INDEX for a corner that does not exist; E_DEGENERATE and E_POLYGON
///         as `RawMeshBuilder::add_face`; E_NONFINITE, E_RANGE for coordinates; E_LIMIT
///         for a line over 1 MiB.
/// \throws LimitError if it needs more memory than the limit.
RawMesh parse_obj(const MeshSource& source);

/// A Wavefront OBJ file, with the shortest numbers that read back to the same doubles.
std::string obj_text(const TriangleMesh& mesh);

}  // namespace endmill
