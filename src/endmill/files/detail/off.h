// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/detail/raw_mesh.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Parses an OFF file in ASCII.
///
/// The file has the word OFF, the numbers of points, faces and edges, and then one line
/// for each point and each face. The prefixes ST, C and N of the word announce texture
/// coordinates, a colour or a normal after the coordinates of each point; these numbers
/// and up to four colour numbers after a face are ignored. A face of more than three
/// corners is split (`fan_corner`). `#` begins a comment.
/// \throws FormatError E_OFF_SYNTAX for other content (4OFF, nOFF and binary OFF are not
///         supported); E_COUNT for counts that are negative or exceed what the file can
///         hold; E_INDEX for a corner that does not exist; E_DEGENERATE and E_POLYGON as
///         `RawMeshBuilder::add_face`; E_NONFINITE, E_RANGE for coordinates; E_LIMIT for
///         a line over 1 MiB.
/// \throws LimitError if it needs more memory than the limit.
RawMesh parse_off(const MeshSource& source);

/// The text of an OFF file. Numbers are the shortest texts that read back to the same
/// doubles.
std::string off_text(const TriangleMesh& mesh);

}  // namespace endmill
