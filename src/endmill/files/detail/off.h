// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/detail/raw_mesh.h"
#include "endmill/files/mesh_file.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The mesh of an OFF file in ASCII: the word OFF, the numbers of points, faces and edges,
/// then each point and each face on a line of its own. With the prefixes ST, C and N
/// (texture, colour, normal) a point's line goes on after x, y, z; these numbers, and up
/// to four of a colour after a face, are ignored. Faces of more than three corners are
/// split (`fan_corner`). `#` begins a comment.
/// \throws FormatError E_OFF_SYNTAX for what is no such file (4OFF, nOFF and binary OFF
///         are not supported); E_COUNT for counts that are negative or more than the file
///         can hold; E_INDEX for a corner that does not exist; E_DEGENERATE and E_POLYGON
///         as `RawMeshBuilder::add_face`; E_NONFINITE, E_RANGE for coordinates; E_LIMIT
///         for a line over 1 MiB.
/// \throws LimitError if it needs more memory than the limit.
RawMesh parse_off(const MeshSource& source);

/// An OFF file, with the shortest numbers that read back to the same doubles.
std::string off_text(const TriangleMesh& mesh);

}  // namespace endmill
