// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/path_options.h"

#include <array>

#include "cli/arguments.h"
#include "endmill/core/error.h"
#include "endmill/io/path_file.h"

namespace endmill {
namespace {

constexpr std::array programmed_points{Choice<bool>{"tip", false},
                                       Choice<bool>{"centre", true}};

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
            "ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER_RADIUS in mm; default "
            "that of the path or its summary")
        ->type_name("CUTTER");
}

void add_reading_options(CLI::App& command, PathOptions& path)
{
    add_choice<bool>(command, "--programmed-point", path.centre_is_programmed,
                     programmed_points, "what the coordinates of a program say");
    add_number(command, {"--arc-tolerance", "MM", "from an arc to its chords"},
               path.arc_tolerance);
    command.add_flag("--block-delete", path.block_delete,
                     "leave out blocks that begin with /");
}

Program read_program_for(const PathOptions& path, const std::optional<Cutter>& cutter,
                         const CommonOptions& options)
{
    PathReadOptions reading;
    reading.limits = options.limits;
    reading.gcode.arc_tolerance_mm = path.arc_tolerance;
    reading.gcode.block_delete = path.block_delete;
    if (path.centre_is_programmed) {
        if (!cutter)
            throw DomainError{
                "--programmed-point centre: expected --cutter or a file that names the "
                "cutter, to know where the tip is"};
        reading.gcode.programmed_point_height_mm = cutter->corner_radius();
    }
    return read_program(path.file, reading);
}

}  // namespace endmill
