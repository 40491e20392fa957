// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "endmill/cutter/cutter.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/read_file.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

namespace endmill {

/// The kinds of files that hold a tool path.
enum class PathFormat {
    Csv,        ///< with the columns of `tool_path_csv`
    Gcode,      ///< RS-274
    Canonical,  ///< what `rs274 -g` prints
    Apt,        ///< APT CL data
};

/// What a file that holds a path does not say of itself.
struct PathReadOptions {
    ReadLimits limits = {};       ///< on coordinates and memory; they rule over `gcode`'s
    GcodeReadOptions gcode = {};  ///< for machine programs
};

/// The kind of a file, by its content, or else by its extension: .csv; .apt, .cl, .cls;
/// .ngc, .nc, .gcode, .tap, .cnc, .mpf, in capitals or not.
/// \param path for its extension and messages.
/// \throws FormatError E_FORMAT for another kind of file, which is named if it is known.
PathFormat path_format(std::string_view content, const std::filesystem::path& path);

/// `options.gcode` as the limits bound it.
GcodeReadOptions gcode_reading(const PathReadOptions& options);

/// The tool path in the content of a file of any of these kinds.
/// \param path for its extension and messages.
/// \throws as `read_program`, which reads the file first.
Program parse_program(std::string_view content, const std::filesystem::path& path,
                      const PathReadOptions& options = {});

/// Reads a tool path from a file of any of these kinds.
/// \throws FormatError, LimitError as `read_file`, `path_format` and the reader of the
///         kind: `parse_tool_path`, `parse_gcode`, `parse_canonical`, `parse_apt`.
Program read_program(const std::filesystem::path& path,
                     const PathReadOptions& options = {});

/// The tool path as a CSV file of the columns pass, point, move, tip_x_mm … tip_z_mm,
/// axis_x … axis_z, tool (if any point has one), patch (if the path is over several), u, v,
/// contact_x_mm … contact_z_mm, normal_x … normal_z, feed_mm_per_min and spindle_rpm (each
/// if any point has one), a line a point. Numbers have the shortest text that reads back
/// to the same double; what a point does not have is an empty cell. The same bytes with
/// any number of threads.
/// \throws DomainError if a number is not finite, or there are conditions or normals for some
/// points and not for all.
std::string tool_path_csv(const ToolPath& path);

/// The same with a last column, limit: what keeps the feed of each move from being higher.
/// \param limits words without commas and quotes, one a point; empty where there is none.
/// \throws DomainError as above, or unless there is a word for each point.
std::string tool_path_csv(const ToolPath& path, std::span<const std::string_view> limits);

/// The part that a path was made for.
struct PartReference {
    std::filesystem::path file;         ///< from where the summary stands
    LengthUnit units = LengthUnit::Mm;  ///< of a mesh
    UpAxis up = UpAxis::Z;              ///< likewise
};

/// What the summary.json beside a tool path says that the path itself does not. What it
/// does not say, or says is null, is none.
struct PathSummary {
    std::optional<std::string> name;
    std::optional<PartReference> part;
    std::optional<Cutter> cutter;
    std::optional<double> chord_tolerance_mm;
    std::optional<double> inner_tolerance_mm;  ///< gouge
    std::optional<double> outer_tolerance_mm;  ///< material left, beside the scallop
    std::optional<double> scallop_mm;
    std::optional<double> feed_mm_per_min;
    std::optional<double> spindle_rpm;

    /// The narrowest of the tolerances that the path was planned to.
    std::optional<double> tolerance_mm() const;
};

/// Reads the summary.json in the folder of `tool_path`.
/// \return nothing if there is none.
/// \throws FormatError, LimitError as `read_file` and `JsonDocument`; FormatError E_JSON
///         for a cutter that is no word of one, a number that is not above 0, or another
///         type. Keys that are not read may hold anything.
std::optional<PathSummary> read_path_summary(const std::filesystem::path& tool_path,
                                             const ReadLimits& limits = {});

}  // namespace endmill
