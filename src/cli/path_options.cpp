// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/path_options.h"

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/idle_options.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

namespace endmill {
namespace {

constexpr double most_interpreter_seconds = 86400;

constexpr std::array programmed_points{
    Choice<ProgrammedPoint>{"tip", ProgrammedPoint::Tip},
    Choice<ProgrammedPoint>{"centre", ProgrammedPoint::Centre}};

constexpr std::array interpreters{Choice<Interpreter>{"endmill", Interpreter::Endmill},
                                  Choice<Interpreter>{"linuxcnc", Interpreter::LinuxCnc}};

// Refuses options that do not apply to the format of the file. G-code accepts all
// of them. The output of rs274 may have arcs and a programmed centre, but no deleted
// blocks. Other files accept none of them.
void require_effect(const PathOptions& path, const CommonOptions& options)
{
    if (!path.arc_tolerance && path.programmed_point == ProgrammedPoint::Tip &&
        !path.block_delete && path.interpreter == Interpreter::Endmill)
        return;
    const PathFormat format =
        path_format(read_file(path.file, options.limits), path.file);
    if (format == PathFormat::Gcode)
        return;
    const bool is_canonical = format == PathFormat::Canonical;
    const std::string kind = is_canonical                ? "the output of rs274 -g"
                             : format == PathFormat::Apt ? "APT CL data"
                                                         : "a tool path (CSV)";
    const auto refuse = [&](const std::string& option, const std::string& why) {
        throw DomainError{option + ": " + printable(path.file) + " is " + kind + ", " +
                          why + "; this option expects G-code"};
    };
    if (path.interpreter != Interpreter::Endmill)
        refuse("--interpreter linuxcnc", is_canonical ? "which an interpreter has written"
                                                      : "which needs no interpreter");
    if (path.block_delete)
        refuse("--block-delete", is_canonical
                                     ? "from which rs274 -b has removed such blocks"
                                     : "which has no optional blocks");
    if (is_canonical)
        return;
    if (path.programmed_point == ProgrammedPoint::Centre)
        refuse("--programmed-point centre", "whose coordinates are those of the tip");
    refuse("--arc-tolerance", "which has no arcs");
}

// A folder that exists: that of the results, one above it, or the working folder.
std::filesystem::path existing_folder(const std::string& output)
{
    std::error_code ignored;
    std::filesystem::path folder = std::filesystem::absolute(output, ignored);
    while (!output.empty() && folder.has_relative_path()) {
        if (std::filesystem::is_directory(folder, ignored))
            return folder;
        folder = folder.parent_path();
    }
    return std::filesystem::current_path();
}

// The machine of the options is that of a program. Other files need none to be read.
void add_rotary_reading(PathReadOptions& reading, const PathOptions& path,
                        const std::optional<Cutter>& cutter, const CommonOptions& options)
{
    refuse_idle_rotary_options(path.rotary, options);
    const auto setup = part_on_machine(path.rotary, path.tool_length, options);
    if (!setup)
        return;
    const PathFormat format =
        path_format(read_file(path.file, options.limits), path.file);
    if (format == PathFormat::Gcode || format == PathFormat::Canonical)
        reading.gcode.rotary =
            rotary_reading(path.rotary, *setup, cutter ? cutter->radius() : 0);
}

// Whether a summary has values by which a path is judged.
bool states_limits(const PathSummary& known)
{
    return known.part || known.cutter || known.tolerance_mm() || known.scallop_mm;
}

}  // namespace

void add_path_options(CLI::App& command, PathOptions& path)
{
    command
        .add_option("TOOLPATH", path.file,
                    "tool path (CSV), G-code, APT CL data or the output of rs274 -g")
        ->required();
    add_cutter_option(command, path);
}

void add_cutter_option(CLI::App& command, PathOptions& path)
{
    command
        .add_option_function<std::string>(
            "--cutter",
            [&path](const std::string& word) {
                path.cutter = cutter_argument("--cutter", word);
            },
            "ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER_RADIUS in mm (default: "
            "that of the path or its summary)")
        ->type_name("CUTTER");
}

void add_reading_options(CLI::App& command, PathOptions& path)
{
    add_choice<ProgrammedPoint>(
        command, "--programmed-point", path.programmed_point, programmed_points,
        "G-code: point of the cutter that the coordinates give (default tip)");
    add_number(command,
               {"--arc-tolerance", "MM",
                "G-code: largest distance from an arc to its chords (default 0.001)"},
               path.arc_tolerance);
    command.add_flag("--block-delete", path.block_delete,
                     "G-code: skip blocks that begin with /");
    add_choice<Interpreter>(command, "--interpreter", path.interpreter, interpreters,
                            "G-code: read by endmill (default), or run by LinuxCNC's "
                            "rs274: parameters, O-words, G10, G92");
    add_number(command,
               {"--interpreter-seconds", "S", "largest time for --interpreter linuxcnc",
                NumberDomain::above_zero_to(most_interpreter_seconds)},
               path.interpreter_seconds);
}

void add_tools_options(CLI::App& command, PathOptions& path)
{
    command
        .add_option("--tools", path.tools,
                    "tool table with the cutter of each tool number: endmill-tools/1, or "
                    "a .tbl of LinuxCNC")
        ->type_name("FILE");
    static const std::array units{
        Choice<double>{"mm", 1},
        Choice<double>{"inch", millimetres_per(ProgramUnit::Inch)}};
    add_choice<double>(command, "--tools-units", path.tools_unit_mm, units,
                       "unit of the diameters in a .tbl, which does not state it");
}

void refuse_idle_tool_options(const PathOptions& path, const CommonOptions& options)
{
    if (path.tools.empty())
        refuse_idle_options(options, std::array{"--tools-units"}, "one tool", "--tools");
    else
        refuse_idle_options(options, std::array{"--cutter", "--tool"}, "--tools",
                            "only one of these options");
}

void add_reading(Json& summary, const PathOptions& path)
{
    summary["programmed_point"] =
        word_for<ProgrammedPoint>(path.programmed_point, programmed_points);
    summary["arc_tolerance_mm"] =
        path.arc_tolerance.value_or(GcodeReadOptions{}.arc_tolerance_mm);
    summary["block_delete"] = path.block_delete;
    add_interpreter(summary, path);
}

void take_reading(PathOptions& path, const Json& summary)
{
    const auto text = [&](const char* key) {
        const auto found = summary.find(key);
        return found != summary.end() && found->is_string() ? found->get<std::string>()
                                                            : "";
    };
    for (const auto& [word, point] : programmed_points)
        if (text("programmed_point") == word)
            path.programmed_point = point;
    const auto arcs = summary.find("arc_tolerance_mm");
    if (arcs != summary.end() && arcs->is_number() &&
        *arcs != GcodeReadOptions{}.arc_tolerance_mm && arcs->get<double>() > 0)
        path.arc_tolerance = arcs->get<double>();
    path.block_delete = summary.value("block_delete", Json{}) == true;
    path.rotary.wrapped = text("wrapped");
    path.tools = text("tool_table");
}

void add_interpreter(Json& summary, const PathOptions& path)
{
    summary["interpreter"] = word_for<Interpreter>(path.interpreter, interpreters);
}

PathSummary path_summary_of(const PathOptions& path, const CommonOptions& options)
{
    if (path.cutter)
        require_within_extent("--cutter", *path.cutter, options.limits);
    std::optional<PathSummary> known = read_path_summary(path.file, options.limits);
    if (!known)
        return {};
    const std::string beside = printable(path.file) + ": the summary.json beside it ";
    switch (summary_match(*known, read_file(path.file, options.limits))) {
        case SummaryMatch::Described:
            break;
        case SummaryMatch::Unnamed:
            if (states_limits(*known))
                warn(options, beside +
                                  "names no toolpath_sha256 and may describe an "
                                  "earlier path; its values are used");
            break;
        case SummaryMatch::Other:
            warn(options, beside +
                              "describes another path (toolpath_sha256) and is not "
                              "used: no part, cutter or limits are taken from it");
            return {};
    }
    return *std::move(known);
}

PathReadOptions path_reading(const PathOptions& path, const std::optional<Cutter>& cutter,
                             const CommonOptions& options)
{
    PathReadOptions reading;
    reading.limits = options.limits;
    reading.several_cutters = !path.tools.empty();
    if (path.interpreter == Interpreter::Endmill)
        refuse_idle_options(options, std::array{"--interpreter-seconds"},
                            "--interpreter endmill", "--interpreter linuxcnc");
    require_effect(path, options);
    if (path.arc_tolerance)
        reading.gcode.arc_tolerance_mm = *path.arc_tolerance;
    reading.gcode.block_delete = path.block_delete;
    add_rotary_reading(reading, path, cutter, options);
    if (path.programmed_point == ProgrammedPoint::Centre) {
        if (!cutter)
            throw DomainError{
                "--programmed-point centre: the cutter is not known; expected --cutter "
                "or "
                "a file that names it"};
        reading.gcode.programmed_point_height_mm = cutter->corner_radius();
    }
    return reading;
}

std::vector<NumberedTool> read_tools_for(const PathOptions& path,
                                         const CommonOptions& options)
{
    if (path.tools.empty())
        return {};
    return read_tool_table(path.tools, {options.limits, path.tools_unit_mm});
}

Program program_of_text(std::string_view text, const PathOptions& path,
                        const PathReadOptions& reading, const CommonOptions& options)
{
    const std::string file = printable(path.file);
    if (path.interpreter == Interpreter::Endmill) {
        const ProgressLine progress{"reading " + file, options};
        return parse_program(text, path.file, reading);
    }
    ProgressLine progress{fmt::format("running {} in LinuxCNC's rs274, at most {:g} s",
                                      file, path.interpreter_seconds),
                          options};
    const std::string moves = canonical_output({.text = text,
                                                .file = file,
                                                .folder = existing_folder(options.output),
                                                .block_delete = path.block_delete,
                                                .most_seconds = path.interpreter_seconds,
                                                .limits = options.limits,
                                                .tools = read_tools_for(path, options)});
    progress.begin("reading the moves of " + file);
    GcodeReadOptions canonical_reading = gcode_reading(reading);
    canonical_reading.machine_position_mm = least_machine_position_mm;
    return parse_canonical(moves, file + " (output of rs274)", canonical_reading);
}

std::optional<std::string> rounding_remark(const Program& program, double tolerance_mm)
{
    constexpr double negligible_share = 0.1;
    if (!(program.position_error_mm > negligible_share * tolerance_mm))
        return std::nullopt;
    return fmt::format(
        "the output of rs274 has four decimals, so that positions are known to {} mm; "
        "the "
        "tolerance is {} mm",
        shown_bound(program.position_error_mm), shown_limit(tolerance_mm));
}

Program read_program_for(const PathOptions& path, const std::optional<Cutter>& cutter,
                         const CommonOptions& options,
                         const std::optional<MachineMotion>& machine)
{
    PathReadOptions reading = path_reading(path, cutter, options);
    reading.machine = machine;
    const double radius = cutter ? cutter->radius() : 0;
    if (machine && path.rotary.machine.empty()) {
        RotaryOptions rotary = path.rotary;
        rotary.frame = machine->interpolation;
        reading.gcode.rotary = rotary_reading(rotary, machine->setup, radius);
    }
    return program_of_text(read_file(path.file, options.limits), path, reading, options);
}

}  // namespace endmill
