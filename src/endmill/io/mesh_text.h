// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A kind of mesh file that can be written.
enum class MeshFormat { Stl, StlAscii, Obj, Ply, Off };

/// All of them, as `--format` names them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> mesh_format_names{"stl", "stl-ascii",
                                                                   "obj", "ply", "off"};

/// The extension of such files, ".stl", ".obj", ".ply" or ".off".
std::string_view mesh_extension(MeshFormat format);

/// The bytes of a file in mm, for `OutputFolder::write`. `read_mesh` gets the same
/// triangles with the same corners from it, binary STL excepted, whose coordinates are
/// rounded to float; in OBJ, PLY and OFF also the same numbers, if every point is used, no
/// two coincide and every triangle has an area. STL numbers points as they come up.
/// \throws DomainError as `stl_text`, for binary STL.
std::string mesh_text(const TriangleMesh& mesh, MeshFormat format);

}  // namespace endmill
