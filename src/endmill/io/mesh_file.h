// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/io/read_limits.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// What a 1 in a mesh file stands for.
enum class LengthUnit { Mm, Inch };

/// All of them, as `--units` names them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> length_unit_names{"mm", "inch"};

/// The axis of a mesh file that points upwards.
enum class UpAxis { X, Y, Z, MinusX, MinusY, MinusZ };

/// All of them, as `--up` names them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> up_axis_names{"x",  "y",  "z",
                                                               "-x", "-y", "-z"};

/// What a mesh file does not say of itself.
struct MeshReadOptions {
    ReadLimits limits = {};             ///< on coordinates in mm, and memory
    LengthUnit units = LengthUnit::Mm;  ///< inches are converted
    UpAxis up = UpAxis::Z;              ///< is turned to +z; a rotation, never a mirror
};

/// A mesh and what was done to what its file holds.
struct MeshFile {
    std::string name;   ///< of the file, without folder and extension
    TriangleMesh mesh;  ///< in mm; no two points are equal, each is used, each triangle
                        ///< has an area. Nothing else is said of its topology.
    std::size_t welded_points;  ///< corners (STL) or points that were others' equal
    /// Numbers, rising from 0, of those left out, since their corners lie on a line.
    std::vector<std::size_t> degenerate_triangles;
    std::vector<std::string> notes;  ///< each change of these and others, in a sentence
};

/// Reads an STL, OBJ, PLY or OFF file by its extension, in capitals or not. Points keep
/// their order, or come in that of the triangles (STL); triangles keep theirs.
/// \throws FormatError as `read_file`, `parse_stl`, `parse_obj`, `parse_ply` and
///         `parse_off`; E_FORMAT for another extension, or if the content is plainly of
///         another format; E_EMPTY if there are no triangles, E_DEGENERATE if none has an
///         area.
/// \throws LimitError if the mesh needs more memory than the limit.
MeshFile read_mesh(const std::filesystem::path& path,
                   const MeshReadOptions& options = {});

/// The same from `content`, which is given up as soon as it is parsed; `path` serves for
/// messages, the name and the extension.
MeshFile parse_mesh(std::string content, const std::filesystem::path& path,
                    const MeshReadOptions& options = {});

}  // namespace endmill
