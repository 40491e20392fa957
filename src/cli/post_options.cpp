// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/post_options.h"

#include <array>

#include "cli/arguments.h"
#include "endmill/post/program.h"

namespace endmill {
namespace {

constexpr std::array formats{Choice<PostFormat>{"gcode", PostFormat::Gcode},
                             Choice<PostFormat>{"apt", PostFormat::Apt}};

// Controls accept tool numbers of at most five digits.
constexpr int greatest_tool = 99999;

void add_program_options(CLI::App& command, PostOptions& options)
{
    add_number(command,
               {"--safe-height", "MM",
                "G-code: height of rapids (default 5 above all moves at feed, but not "
                "below a rapid of the path)",
                NumberDomain::any()},
               options.safe_height);
    add_whole_number(
        command,
        {"--tool-number", "G-code: number of the tool (default: the path's own, or 1)", 0,
         greatest_tool},
        [&options](int number) { options.tool = number; })
        ->type_name("N");
    command.add_flag("--line-numbers", options.line_numbers,
                     "G-code: write N1, N2, ... before every block");
    add_choice<bool>(command, "--comments", options.comments, yes_first,
                     "G-code: write name and cutter as comments (default yes)");
    add_whole_number(
        command,
        {"--decimals", "digits after the decimal point (default 4)", 0, most_decimals},
        [&options](int decimals) { options.decimals = decimals; })
        ->type_name("N");
}

}  // namespace

PostFormatNames names_of(PostFormat format)
{
    return {std::string{word_for<PostFormat>(format, formats)},
            format == PostFormat::Gcode ? ".ngc" : ".apt"};
}

void add_post_options(CLI::App& command, PostOptions& options)
{
    add_path_options(command, options.path);
    add_choice<PostFormat>(command, "--format", options.format, formats,
                           "language of the program (default gcode)");
    add_number(
        command,
        {"--feed", "MM_PER_MIN",
         "feed of all moves except rapids (default: the path's own, or its summary's)",
         NumberDomain::of_machine()},
        options.feed_mm_per_min);
    add_number(command,
               {"--spindle-rpm", "RPM",
                "spindle speed (default: the path's own, or its summary's)",
                NumberDomain::of_machine()},
               options.spindle_rpm);
    add_reading_options(command, options.path);
    add_program_options(command, options);
    add_common_options(command, options.common);
}

}  // namespace endmill
