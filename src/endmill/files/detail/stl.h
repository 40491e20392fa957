// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/mesh_file.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Whether `content` is as long as a binary STL with its number of triangles is: 84 bytes
/// and 50 a triangle. Such a file is binary also if it begins with "solid".
bool is_binary_stl(std::string_view content);

/// The corners in mm of the triangles of an STL file, binary or ASCII, as `weld` takes
/// them. The facets' normals, attributes and the solids' names are ignored; an ASCII file
/// may hold several solids.
/// \throws FormatError E_STL_SIZE if a binary file is not as long as its header says;
///         E_STL_SYNTAX for ASCII that is not STL; E_NONFINITE, E_RANGE for coordinates;
///         E_LIMIT for a line over 1 MiB.
/// \throws LimitError if it needs more memory than the limit.
std::vector<std::array<Vec3, 3>> parse_stl(const MeshSource& source);

/// A binary STL file. Coordinates are rounded to float, relatively by at most 2^-24.
/// \throws DomainError if a coordinate is beyond the range of float.
std::string stl_text(const TriangleMesh& mesh);

/// An ASCII STL file, with the shortest numbers that read back to the same doubles.
std::string stl_ascii_text(const TriangleMesh& mesh);

}  // namespace endmill
