// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/rotary_options.h"
#include "endmill/cutter/cutter.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/path_file.h"

namespace endmill {

/// The point of the cutter to which the coordinates of a program refer.
enum class ProgrammedPoint { Tip, Centre };

/// The tool path of a command, and the options for reading it.
struct PathOptions {
    std::string file;
    std::optional<Cutter> cutter;  ///< default: that of the path or its summary
    std::optional<double> arc_tolerance = {};  ///< mm, from a program's arc to its chords
    ProgrammedPoint programmed_point = ProgrammedPoint::Tip;
    bool block_delete = false;  ///< skip blocks that begin with /
    Interpreter interpreter = Interpreter::Endmill;
    double interpreter_seconds = 60;  ///< s, limit of another interpreter
    std::string tools;  ///< file with a tool table; empty: the path has one tool
    std::optional<double> tools_unit_mm = {};  ///< mm, unit of a table that states none
    RotaryOptions rotary = {};                 ///< the machine, for rotary axes
    double tool_length = 0;  ///< mm, from the spindle nose to the tip, for rotary axes
};

/// Adds the argument TOOLPATH and the option --cutter.
void add_path_options(CLI::App& command, PathOptions& path);

/// Adds the option --cutter.
void add_cutter_option(CLI::App& command, PathOptions& path);

/// Adds the options for reading a program.
void add_reading_options(CLI::App& command, PathOptions& path);

/// Adds the options --tools and --tools-units.
void add_tools_options(CLI::App& command, PathOptions& path);

/// Refuses --tools-units without --tools, and --cutter and --tool with it.
/// \throws DomainError
void refuse_idle_tool_options(const PathOptions& path, const CommonOptions& options);

/// Adds their values to a summary: programmed_point, arc_tolerance_mm, block_delete,
/// interpreter.
void add_reading(Json& summary, const PathOptions& path);

/// Sets the options for reading a program by the keys of `add_reading`, and by wrapped and
/// tool_table, in a summary. Values of another type or unknown words set nothing, and neither
/// does interpreter: no file decides which program runs.
void take_reading(PathOptions& path, const Json& summary);

/// Adds the key interpreter only.
void add_interpreter(Json& summary, const PathOptions& path);

/// Reads the summary.json beside the path. One that describes another file is not used,
/// and a warning says so. One that does not name its file is used with a warning.
/// \throws FormatError, LimitError as `read_path_summary` and `read_file`.
PathSummary path_summary_of(const PathOptions& path, const CommonOptions& options);

/// The options for the reader of the path.
/// \throws DomainError as `read_program_for`.
PathReadOptions path_reading(const PathOptions& path, const std::optional<Cutter>& cutter,
                             const CommonOptions& options);

/// Reads the tool table of --tools. Empty without this option.
/// \throws DomainError, FormatError, LimitError as `read_tool_table`.
std::vector<NumberedTool> read_tools_for(const PathOptions& path,
                                         const CommonOptions& options);

/// Parses the content of the path's file, or runs the interpreter of the options on it,
/// with a line of progress.
/// \throws as `read_program_for`.
Program program_of_text(std::string_view text, const PathOptions& path,
                        const PathReadOptions& reading, const CommonOptions& options);

/// A remark if the positions of `program` are known less precisely than a tenth of the
/// tolerance, as in the output of LinuxCNC's interpreter; else nothing.
std::optional<std::string> rounding_remark(const Program& program, double tolerance_mm);

/// Reads the path.
/// \param cutter the cutter, if it is known before the path is read.
/// \throws DomainError for an option that does not apply to the format of the file, and
///         if the centre is programmed and `cutter` is empty, since the tip is then not
///         known; FormatError, LimitError as `read_program`; as `canonical_output` if
///         the options name an interpreter.
/// \param machine of the summary beside the path, which interpolates a CSV path, and runs a
///        program unless the options name a machine. Wrapped words follow the options.
Program read_program_for(const PathOptions& path, const std::optional<Cutter>& cutter,
                         const CommonOptions& options,
                         const std::optional<MachineMotion>& machine = {});

}  // namespace endmill
