// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/path_options.h"

#include <array>

#include "cli/arguments.h"
#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::array programmed_points{
    Choice<ProgrammedPoint>{"tip", ProgrammedPoint::Tip},
    Choice<ProgrammedPoint>{"centre", ProgrammedPoint::Centre}};

// Refuses options that do not apply to the format of the file. G-code accepts all
// three. The output of rs274 may have arcs and a programmed centre, but no deleted
// blocks. Other files accept none of them.
void require_effect(const PathOptions& path, const CommonOptions& options)
{
    if (!path.arc_tolerance && path.programmed_point == ProgrammedPoint::Tip &&
        !path.block_delete)
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

}  // namespace

void add_path_options(CLI::App& command, PathOptions& path)
{
    command
        .add_option("TOOLPATH", path.file,
                    "tool path (CSV), G-code, APT CL data or the output of rs274 -g")
        ->required();
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
}

void add_reading(Json& summary, const PathOptions& path)
{
    summary["programmed_point"] =
        word_for<ProgrammedPoint>(path.programmed_point, programmed_points);
    summary["arc_tolerance_mm"] =
        path.arc_tolerance.value_or(GcodeReadOptions{}.arc_tolerance_mm);
    summary["block_delete"] = path.block_delete;
}

PathReadOptions path_reading(const PathOptions& path, const std::optional<Cutter>& cutter,
                             const CommonOptions& options)
{
    PathReadOptions reading;
    reading.limits = options.limits;
    require_effect(path, options);
    if (path.arc_tolerance)
        reading.gcode.arc_tolerance_mm = *path.arc_tolerance;
    reading.gcode.block_delete = path.block_delete;
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

Program read_program_for(const PathOptions& path, const std::optional<Cutter>& cutter,
                         const CommonOptions& options)
{
    const ProgressLine progress{"reading " + printable(path.file), options};
    return read_program(path.file, path_reading(path, cutter, options));
}

}  // namespace endmill
