// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "endmill/core/vec.h"
#include "endmill/files/detail/raw_mesh.h"
#include "endmill/files/mesh_file.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The mesh of a PLY file, ASCII or binary of either byte order: x, y and z, of any type,
/// of the element "vertex", and the list "vertex_indices" or "vertex_index" of the
/// element "face", which comes after it. Everything else is skipped. In ASCII each item
/// stands on a line of its own. Faces of more than three corners are split (`fan_corner`).
/// \throws FormatError as `parse_ply_header`, and E_PLY_SYNTAX if one of these is missing
///         or of an unfit type; E_COUNT if the items or a list go on past the end of the
///         file, or the file past the items; E_INDEX for a corner that does not exist;
///         E_DEGENERATE and E_POLYGON as `RawMeshBuilder::add_face`; E_NONFINITE, E_RANGE
///         for coordinates.
/// \throws LimitError if it needs more memory than the limit.
RawMesh parse_ply(const MeshSource& source);

/// A binary little-endian PLY file that reads back to the same doubles.
/// \param normals one per point, written as nx, ny, nz; or none.
/// \throws DomainError for another number of normals, or one that is not finite.
std::string ply_text(const TriangleMesh& mesh, std::span<const Vec3> normals = {});

}  // namespace endmill
