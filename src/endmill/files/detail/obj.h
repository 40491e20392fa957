// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/detail/raw_mesh.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Parses a Wavefront OBJ file.
///
/// Used are the statements `v` (point) and `f` (face). A corner of a face is written as
/// v, v/vt, v//vn or v/vt/vn; v counts from 1, or backwards from -1, and refers to a
/// point above the face. A face of more than three corners is split (`fan_corner`).
/// Ignored are numbers after z (a weight or a colour), texture coordinates, normals,
/// groups, materials, points, lines and display attributes. Lines that begin with another
/// word of letters, digits and underscores are skipped, and a note counts them.
/// \throws FormatError E_OBJ_SYNTAX for a line that begins with anything else, for free-form
///         curves and surfaces, and for a file of unknown words only; E_INDEX for a corner that does not exist; E_DEGENERATE and E_POLYGON
///         as `RawMeshBuilder::add_face`; E_NONFINITE, E_RANGE for coordinates; E_LIMIT
///         for a line over 1 MiB.
/// \throws LimitError if it needs more memory than the limit.
RawMesh parse_obj(const MeshSource& source);

/// The text of a Wavefront OBJ file. Numbers are the shortest texts that read back to the
/// same doubles.
std::string obj_text(const TriangleMesh& mesh);

}  // namespace endmill
