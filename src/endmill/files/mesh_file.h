// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"
#include "endmill/files/detail/text_scanner.h"
#include "endmill/files/read_file.h"
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

/// The content of a mesh file and how it is to be read.
struct MeshSource {
    std::string_view content;  ///< of the file, whole
    std::string file;          ///< its name for messages
    ReadLimits limits = {};    ///< on coordinates, after conversion, and memory
    double mm_per_unit = 1;    ///< mesh files carry no unit: what a 1 in it stands for
};

/// A place in a file, for complaints.
class FilePlace {
public:
    static FilePlace line(std::size_t number) { return {number, false}; }  ///< from 1
    static FilePlace byte(std::size_t offset) { return {offset, true}; }   ///< from 0

    /// As `FormatError::Complaint::place`: "LINE" or "@BYTE".
    std::string text() const { return (is_byte_ ? "@" : "") + std::to_string(number_); }

private:
    FilePlace(std::size_t number, bool is_byte) : number_{number}, is_byte_{is_byte} {}

    std::size_t number_;
    bool is_byte_;
};

/// A point in mm from the coordinates that stand in the file.
/// \throws FormatError E_NONFINITE or E_RANGE if one is not finite, or beyond the limit.
Vec3 point_mm(const MeshSource& source, const Vec3& coordinates, FilePlace place);

/// The next three words of a line as a point in mm.
/// \throws FormatError as `TextScanner::number` and `point_mm`.
Vec3 scan_point_mm(TextScanner& scanner, const MeshSource& source);

/// A number of a point, counted from 0.
/// \throws FormatError E_INDEX unless it is one of `points`.
std::int32_t point_number(const MeshSource& source, std::int64_t number,
                          std::size_t points, FilePlace place);

/// \throws LimitError if a mesh of so many points or triangles cannot be numbered: there
/// are more than 2^31 - 1.
void require_numbers(const MeshSource& source, std::uint64_t points_or_triangles);

/// An error with the file's name.
FormatError complaint(const MeshSource& source, const std::string& code, FilePlace place,
                      const std::string& found, const std::string& expected);

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
