// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "endmill/core/vec.h"
#include "endmill/files/detail/raw_mesh.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Parses a PLY file, in ASCII or in binary of either byte order.
///
/// Used are the properties x, y and z, of any type, of the element "vertex", and the list
/// "vertex_indices" or "vertex_index" of the element "face", which must follow "vertex", and
/// its "face_number", of any whole type, if it has one.
/// All other elements and properties are skipped. In ASCII every item has a line of its
/// own. A face of more than three corners is split (`fan_corner`).
/// \throws FormatError as `parse_ply_header`; E_PLY_SYNTAX if a used element or property
///         is missing or of a wrong type; E_COUNT if items or a list exceed the file, or
///         the file continues after the items; E_INDEX for a corner that does not exist, or
///         a face number below 1;
///         E_DEGENERATE and E_POLYGON as `RawMeshBuilder::add_face`; E_NONFINITE, E_RANGE
///         for coordinates.
/// \throws LimitError if it needs more memory than the limit.
RawMesh parse_ply(const MeshSource& source);

/// The content of a binary little-endian PLY file that reads back to the same doubles.
/// \param normals one for each point, written as nx, ny, nz; or none.
/// \param face_numbers one for each triangle, written as face_number; or none.
/// \throws DomainError for another number of normals or face numbers, or a normal that is not
///         finite.
std::string ply_text(const TriangleMesh& mesh, std::span<const Vec3> normals = {},
                     std::span<const std::int32_t> face_numbers = {});

}  // namespace endmill
