// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/read_file.h"
#include "endmill/mesh/triangle_mesh.h"

/// \file
/// Mesh files: reading of STL, OBJ, PLY and OFF with a fixed treatment of equal points,
/// degenerate triangles and unused points, and writing of the same formats.

namespace endmill {

/// The length unit of the coordinates in a mesh file.
enum class LengthUnit { Mm, Inch };

/// Names of the units as `--units` takes them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> length_unit_names{"mm", "inch"};

/// The axis of a mesh file that points upwards.
enum class UpAxis { X, Y, Z, MinusX, MinusY, MinusZ };

/// Names of the axes as `--up` takes them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> up_axis_names{"x",  "y",  "z",
                                                               "-x", "-y", "-z"};

/// Data that a mesh file does not contain, and limits.
struct MeshReadOptions {
    ReadLimits limits = {};             ///< on coordinates (in mm) and memory
    LengthUnit units = LengthUnit::Mm;  ///< unit in the file; inches are converted to mm
    UpAxis up = UpAxis::Z;              ///< axis that a rotation turns to +z
};

/// A mesh that was read, and a report of every change to the content of the file.
struct MeshFile {
    std::string name;  ///< file name without folder and extension
    /// In mm. No two points are equal, every point is used, and every triangle has an
    /// area. The topology is not checked.
    TriangleMesh mesh;
    std::size_t welded_points;  ///< number of points that were merged with an equal point
    /// Indices, from 0 and rising, of the triangles of the file that were left out
    /// because their corners are collinear.
    std::vector<std::size_t> degenerate_triangles;
    std::vector<std::string> notes;  ///< one sentence for each kind of change
    /// For each triangle the number of its face of a CAD model, from 1; empty if the file has
    /// none. Only PLY files have them.
    std::vector<std::int32_t> face_numbers = {};
};

/// Reads an STL, OBJ, PLY or OFF file. The extension, in either case, selects the format.
/// Points keep the order of the file, or the order of their first triangle (STL).
/// Triangles keep their order.
/// \throws FormatError as `read_file` and as the reader of the format; E_FORMAT for
///         another extension, or if the content belongs to another format; E_EMPTY if
///         there is no triangle, E_DEGENERATE if no triangle has an area.
/// \throws LimitError if the mesh needs more memory than the limit.
MeshFile read_mesh(const std::filesystem::path& path,
                   const MeshReadOptions& options = {});

/// Parses the content of a mesh file as `read_mesh` does.
/// \param content is released as soon as it is parsed, which lowers the peak memory.
/// \param path    used for messages, the name and the extension.
MeshFile parse_mesh(std::string content, const std::filesystem::path& path,
                    const MeshReadOptions& options = {});

/// A mesh that is in no mesh file, treated as one: equal points are welded, degenerate
/// triangles and unused points left out.
/// \param mesh         in mm. \param face_numbers as in `MeshFile`.
/// \param path         used for messages and the name.
/// \param options      its unit must be mm.
/// \throws FormatError, LimitError as `parse_mesh`.
MeshFile treated_mesh(TriangleMesh mesh, std::vector<std::int32_t> face_numbers,
                      const std::filesystem::path& path,
                      const MeshReadOptions& options = {});

/// The format of a mesh file to be written.
enum class MeshFormat { Stl, StlAscii, Obj, Ply, Off };

/// Names of the formats as `--format` takes them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> mesh_format_names{"stl", "stl-ascii",
                                                                   "obj", "ply", "off"};

/// The extension of such a file: ".stl", ".obj", ".ply" or ".off".
std::string_view mesh_extension(MeshFormat format);

/// The content of a mesh file in mm, to be written by `OutputFolder::write`. `read_mesh`
/// reads back the same triangles with the same corners; binary STL rounds coordinates to
/// float. OBJ, PLY and OFF also keep the numbering of the points if every point is used,
/// no two are equal and every triangle has an area. STL numbers points by first use.
/// \param normals one unit normal for each point, or none. PLY stores them as nx, ny, nz;
///                the other formats store no normals of points and ignore them.
/// \param face_numbers one for each triangle, from 1, or none. PLY stores them as
///                face_number; the other formats ignore them.
/// \throws DomainError if a coordinate is beyond the range of float (binary STL); if the
///         number of normals is not that of the points, that of the face numbers not that of
///         the triangles, or a normal is not finite (PLY).
std::string mesh_text(const TriangleMesh& mesh, MeshFormat format,
                      std::span<const Vec3> normals = {},
                      std::span<const std::int32_t> face_numbers = {});

}  // namespace endmill
