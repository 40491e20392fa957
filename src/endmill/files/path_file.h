// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/read_file.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

/// \file
/// Tool paths in files: recognition of the format, reading of all formats, writing of the
/// CSV format, and the summary.json that stands beside a planned path.
///
/// Implemented in `path_file.cpp` (reading), `tool_path_csv.cpp` (writing) and
/// `path_summary.cpp` (summary.json).

namespace endmill {

/// The formats of files that hold a tool path.
enum class PathFormat {
    Csv,        ///< the columns of `tool_path_csv`
    Gcode,      ///< RS-274 (G-code)
    Canonical,  ///< canonical commands as printed by `rs274 -g`
    Apt,        ///< APT CL data
};

/// Data that a file with a tool path does not contain, and limits.
struct PathReadOptions {
    ReadLimits limits = {};  ///< on coordinates and memory; they replace those of `gcode`
    GcodeReadOptions gcode = {};  ///< for machine programs
    /// Whether APT CL data may name several cutters (`AptReadOptions`).
    bool several_cutters = false;
    /// The machine that interpolates a CSV path, without positions; none: the path is
    /// linear. Programs have theirs in `gcode`.
    std::optional<MachineMotion> machine = {};
};

/// The format of a file. The content determines the format if it is unambiguous.
/// Otherwise the extension determines it, in upper or lower case: .csv; .apt, .cl, .cls;
/// .ngc, .nc, .gcode, .tap, .cnc, .mpf.
/// \param path for the extension and for messages.
/// \throws FormatError E_FORMAT for any other file; the message names a recognised
///         format.
PathFormat path_format(std::string_view content, const std::filesystem::path& path);

/// `options.gcode` with the limits of `options.limits`.
GcodeReadOptions gcode_reading(const PathReadOptions& options);

/// Parses the content of a file of any of these formats.
/// \param path for the extension and for messages.
/// \throws as `read_program`, except for errors of opening the file.
Program parse_program(std::string_view content, const std::filesystem::path& path,
                      const PathReadOptions& options = {});

/// Whether the name of the file ends as those of G-code or APT do. Its content may still be
/// something else.
bool has_path_extension(const std::filesystem::path& path);

/// Reads a tool path from a file of any of these formats.
/// \throws FormatError, LimitError as `read_file`, `path_format` and the reader of the
///         format: `parse_gcode`, `parse_canonical`, `parse_apt`, or for CSV:
///         E_CSV with the line for a column that is unknown, lacks its unit or occurs
///         twice; for a vector with a missing column or, in a row, a missing component;
///         for a row with another number of cells than the header, an unknown tip, a cell
///         that is not a finite number, an unknown move, an axis or normal that is not a
///         unit vector, a feed or speed that is not positive, a negative tool number, and
///         a file without rows; E_RANGE for a coordinate beyond the limit.
Program read_program(const std::filesystem::path& path,
                     const PathReadOptions& options = {});

/// The line, from 1, of a row of a CSV tool path, for messages about a path that was
/// read.
/// \param row index of the point, from 0. \pre the text has that row.
std::size_t line_of_row(std::string_view text, std::size_t row);

/// The tool path as a CSV file, one line for each point, with the columns pass, point,
/// move, tip_x_mm … tip_z_mm, axis_x … axis_z, tool (if any point has one), patch (if the
/// path covers several), u, v, contact_x_mm … contact_z_mm, normal_x … normal_z,
/// feed_mm_per_min and spindle_rpm (each if any point has one), x_mm, y_mm, z_mm, r1_deg and
/// r2_deg (if a machine interpolates the path). A number is the shortest
/// text that reads back to the same double; an unknown value is an empty cell. The bytes
/// do not depend on the number of threads.
/// \throws DomainError if a number is not finite.
std::string tool_path_csv(const ToolPath& path);

/// The same with a column `limit` behind spindle_rpm, which states what limits the feed of each move.
/// \param limits one word for each point, without commas and quotes; empty if there is
///         none.
/// \throws DomainError as the other overload, and unless there is one word for each
///         point.
std::string tool_path_csv(const ToolPath& path, std::span<const std::string_view> limits);

/// The same without the column `limit` in pieces, for a path whose file need not fit into
/// memory.
/// \param sink receives the pieces in order; the first is the header.
/// \throws DomainError if a number is not finite, and whatever `sink` throws.
void write_tool_path_csv(const ToolPath& path,
                         const std::function<void(std::string_view piece)>& sink);

/// The same with the column `limit`.
/// \param limit_of the word of a point. It is called by any thread.
/// \param sink receives the pieces in order; the first begins with the header.
/// \throws DomainError if a number is not finite, and whatever `sink` throws.
void write_tool_path_csv(
    const ToolPath& path,
    const std::function<std::string_view(std::size_t point)>& limit_of,
    const std::function<void(std::string_view piece)>& sink);

/// The part that a path was planned for.
struct PartReference {
    std::filesystem::path file;         ///< path of the part's file
    LengthUnit units = LengthUnit::Mm;  ///< of a mesh file
    UpAxis up = UpAxis::Z;              ///< of a mesh file
};

/// What a verification does with remaining stock where the cutter cannot touch the part, such
/// as in a corner that is sharper than the cutter.
enum class InaccessibleStock {
    Count,   ///< it is judged as everywhere
    Report,  ///< it is measured and not judged
};

/// Names in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> inaccessible_names{"count", "report"};

/// The name of `stock` in files.
inline std::string_view inaccessible_name(InaccessibleStock stock)
{
    return inaccessible_names.at(static_cast<std::size_t>(stock));
}

/// The content of the summary.json beside a tool path. A value that is missing or null in
/// the file is empty.
struct PathSummary {
    std::optional<std::string> name;           ///< of the part
    std::optional<PartReference> part;         ///< that the path was planned for
    std::optional<Cutter> cutter;              ///< that the path was planned for
    std::optional<double> chord_tolerance_mm;  ///< largest chord error
    std::optional<double> inner_tolerance_mm;  ///< largest depth of a gouge
    /// Largest remaining stock along a pass.
    std::optional<double> outer_tolerance_mm;
    std::optional<double> scallop_mm;  ///< scallop height
    /// Whether remaining stock is judged where the cutter cannot touch the part.
    std::optional<InaccessibleStock> inaccessible;
    std::optional<double> feed_mm_per_min;            ///< programmed feed
    std::optional<double> spindle_rpm;                ///< programmed spindle speed
    std::optional<std::size_t> toolpath_points = {};  ///< rows of the path file, if CSV
    std::optional<std::string> toolpath_sha256 = {};  ///< `content_sha256` of that file
    /// The same of a machine program that was written with the path.
    std::optional<std::string> program_sha256 = {};
    std::optional<PartReference> protected_part = {};  ///< that the path must not enter
    /// The machine that interpolates the path or runs the program, without positions.
    std::optional<MachineMotion> machine = {};
    /// List of facets of the part that the path leaves uncut.
    std::optional<std::filesystem::path> skipped_facets = {};
    /// The faces that the path cuts, from 1; empty: all.
    std::vector<int> cut_faces = {};
    /// `content_sha256` of the part whose facets or faces these are.
    std::optional<std::string> part_sha256 = {};

    /// The smallest of the three tolerances, without an outer one of 0: the scallop height then
    /// limits all remaining stock. Nothing if none is known.
    std::optional<double> tolerance_mm() const;
};

/// The SHA-256 of the content of a file, as 64 hexadecimal digits in lower case.
std::string content_sha256(std::string_view content);

/// The same of a content that comes in pieces.
class ContentSha256 {
public:
    ContentSha256();                                          ///< of nothing so far
    ~ContentSha256();                                         ///< releases the state
    ContentSha256(const ContentSha256&) = delete;             ///< it owns a state
    ContentSha256& operator=(const ContentSha256&) = delete;  ///< it owns a state

    void add(std::string_view piece);  ///< adds the next piece

    /// The word of all pieces. \pre It was not called before.
    std::string word();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// How a summary.json belongs to the path file beside it.
enum class SummaryMatch {
    Described,  ///< it names the SHA-256 of this file
    Unnamed,    ///< it names no SHA-256, as an earlier version or a person writes it
    Other,      ///< it describes another file, or this one with other content
};

/// Compares a summary with the content of the path file beside it.
SummaryMatch summary_match(const PathSummary& summary, std::string_view content);

/// Reads the summary.json in the folder of `tool_path`. Unknown keys are ignored.
/// \return nothing if there is no such file.
/// \throws FormatError, LimitError as `read_file` and `JsonDocument`; FormatError E_JSON
///         for an invalid cutter word, a number that is not positive, or a wrong type.
std::optional<PathSummary> read_path_summary(const std::filesystem::path& tool_path,
                                             const ReadLimits& limits = {});

/// The pose of a part on a machine, as `endmill setup` finds it.
struct ClampedPart {
    Eigen::Matrix3d
        part_to_machine;  ///< rotation; rows: the machine's X, Y, Z in the part
    Vec3 clamp;           ///< mm, where the part's origin is clamped
};

/// Reads the keys `part_to_machine` and `clamp_mm` of a summary.json of `setup`.
/// \throws FormatError, LimitError as `read_file` and `JsonDocument`; FormatError E_JSON
///         if the pose is missing, or if it is no rotation.
ClampedPart read_clamped_part(const std::filesystem::path& path,
                              const ReadLimits& limits = {});

}  // namespace endmill
