// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/detail/mesh_source.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Whether `content` has the length of a binary STL with its number of triangles: 84
/// bytes and 50 for each triangle. Such a file is binary even if it begins with "solid".
bool is_binary_stl(std::string_view content);

/// Parses an STL file, binary or ASCII.
/// \return corners of each triangle in mm, as `weld` takes them. Normals, attributes and
///         the names of solids are ignored; an ASCII file may hold several solids.
/// \throws FormatError E_STL_SIZE if the length of a binary file contradicts its header;
///         E_STL_SYNTAX for invalid ASCII; E_NONFINITE, E_RANGE for coordinates; E_LIMIT
///         for a line over 1 MiB.
/// \throws LimitError if it needs more memory than the limit.
std::vector<std::array<Vec3, 3>> parse_stl(const MeshSource& source);

/// The content of a binary STL file. Coordinates are rounded to float, with a relative
/// error of at most 2^-24.
/// \throws DomainError if a coordinate is beyond the range of float.
std::string stl_text(const TriangleMesh& mesh);

/// The text of an ASCII STL file. Numbers are the shortest texts that read back to the
/// same doubles.
std::string stl_ascii_text(const TriangleMesh& mesh);

}  // namespace endmill
