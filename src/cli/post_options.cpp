// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/post_options.h"

#include <array>
#include <filesystem>
#include <vector>

#include "built_in_controls.h"
#include "cli/arguments.h"
#include "cli/idle_options.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/post/program.h"

namespace endmill {
namespace {

constexpr std::array formats{Choice<PostFormat>{"gcode", PostFormat::Gcode},
                             Choice<PostFormat>{"apt", PostFormat::Apt}};
constexpr std::array coolants{Choice<Coolant>{"off", Coolant::Off},
                              Choice<Coolant>{"flood", Coolant::Flood},
                              Choice<Coolant>{"mist", Coolant::Mist}};
constexpr std::array lead_ins{Choice<LeadIn>{"straight", LeadIn::Straight},
                              Choice<LeadIn>{"ramp", LeadIn::Ramp}};
constexpr std::array singular_rules{
    Choice<SingularRule>{"exact", SingularRule::Exact},
    Choice<SingularRule>{"turn", SingularRule::Turn},
    Choice<SingularRule>{"retract", SingularRule::Retract}};
constexpr std::array units{Choice<ProgramUnit>{"mm", ProgramUnit::Mm},
                           Choice<ProgramUnit>{"inch", ProgramUnit::Inch}};
constexpr std::array no_first{Choice<bool>{"no", false}, Choice<bool>{"yes", true}};

// Controls accept tool numbers of at most five digits.
constexpr int greatest_tool = 99999;
// s; a longer wait is a mistake of the unit.
constexpr double longest_dwell_s = 600;
// Degrees; a steeper slope is a plunge.
constexpr double steepest_ramp_deg = 45;

void add_feed_options(CLI::App& command, PostOptions& options)
{
    add_number(
        command,
        {"--feed", "MM_PER_MIN",
         "feed of all moves except rapids (default: the path's own, or its summary's)",
         NumberDomain::of_machine()},
        options.feed_mm_per_min);
    add_number(command,
               {"--plunge-feed-mm-per-min", "MM_PER_MIN",
                "feed of all descents (default: the path's own, or a third of the feed)",
                NumberDomain::of_machine()},
               options.plunge_feed_mm_per_min);
    add_number(command,
               {"--spindle-rpm", "RPM",
                "spindle speed (default: the path's own, or its summary's)",
                NumberDomain::of_machine()},
               options.spindle_rpm);
}

void add_machine_options(CLI::App& command, PostOptions& options)
{
    command
        .add_option("--control", options.control,
                    "G-code: control of the machine, by name or by file (default "
                    "linuxcnc)")
        ->type_name("linuxcnc|fanuc|grbl|FILE");
    add_choice<Coolant>(command, "--coolant", options.coolant, coolants,
                        "G-code: coolant while the spindle turns (default off)");
    add_number(command,
               {"--dwell-s", "S",
                "G-code: wait after the spindle starts (default 2, or 0 if the control "
                "has no dwell)",
                NumberDomain::from_to(0, longest_dwell_s)},
               options.dwell_s);
    add_number(command,
               {"--safe-height", "MM",
                "G-code: height of rapids (default 5 above all moves at feed, but not "
                "below a rapid of the path)",
                NumberDomain::any()},
               options.safe_height);
    add_whole_number(
        command,
        {"--tool-number", "G-code: number of the tool (default: the path's own, or 1)", 1,
         greatest_tool},
        [&options](int number) { options.tool = number; })
        ->type_name("N");
}

void add_motion_options(CLI::App& command, PostOptions& options)
{
    add_choice<LeadIn>(command, "--lead-in", options.lead_in, lead_ins,
                       "G-code: descend vertically, or on a slope along the first cuts "
                       "(default straight)");
    add_number(
        command,
        {"--ramp-angle-deg", "DEG", "--lead-in ramp: angle of the slope over the path",
         NumberDomain::above_zero_to(steepest_ramp_deg)},
        options.ramp_angle_deg);
    add_number(command,
               {"--approach-distance", "MM",
                "G-code: descents to a cut are rapid down to this height above their end "
                "(default: all at plunge feed or on the slope)"},
               options.approach_distance);
    command.add_flag("--arcs", options.arcs,
                     "G-code: fit arcs (G2, G3 in G17, G18, G19) to the cuts");
    add_number(
        command,
        {"--arc-fit-tolerance", "MM",
         "--arcs: largest distance between arc and path (default 0.001 more than the "
         "path's tolerance, or 0.002)"},
        options.arc_fit_tolerance_mm);
}

// Options of programs with rotary axes, beside those for reading them.
void add_rotary_post_options(CLI::App& command, PostOptions& post)
{
    MachinePostOptions& options = post.machine;
    add_rotary_options(command, post.path.rotary);
    command
        .add_option(
            "--tool", options.tool_file,
            "--machine: tool file (endmill-tool/1) with the cutter and the length "
            "from spindle to tip (default length 0)")
        ->type_name("FILE");
    add_number(command,
               {"--tolerance", "MM",
                "--machine: largest deviation of the machine from the path (default half "
                "of the path's tolerance, or 0.005)"},
               options.tolerance);
    add_whole_number(command,
                     {"--angle-decimals",
                      "--machine: digits after the point of rotary words (default 5)", 0,
                      most_decimals},
                     [&options](int decimals) { options.angle_decimals = decimals; })
        ->type_name("N");
    add_number(
        command,
        {"--retract", "MM",
         "--machine: reorient the tool in the air, this far beyond the path, where "
         "no other way leads on (default: never)"},
        options.retract);
    add_number(command,
               {"--rapid-feed", "MM_PER_MIN",
                "--machine: write rapids that turn an axis at this feed (default: G0)",
                NumberDomain::of_machine()},
               options.rapid_feed);
    add_number(command,
               {"--blend", "MM",
                "--machine: how far the control may round corners, G64 P (default: not, "
                "G61)",
                NumberDomain::from_zero()},
               options.blend);
    add_choice<SingularRule>(
        command, "--singular", options.singular, singular_rules,
        "--machine: near the axis of the first rotary axis keep the path (exact), take "
        "that direction (turn), or turn there in the air (retract) (default exact)");
    constexpr double widest_cone_deg = 10;
    add_number(command,
               {"--singular-cone-deg", "DEG",
                "--singular: half angle of the cone that counts as near",
                NumberDomain::above_zero_to(widest_cone_deg)},
               options.singular_cone_deg);
}

void add_text_options(CLI::App& command, PostOptions& options)
{
    add_choice<ProgramUnit>(command, "--units", options.unit, units,
                            "G-code: unit of the program (default mm)");
    add_choice<bool>(command, "--multax", options.multax, no_first,
                     "APT: write MULTAX and the axis of every point (default no)");
    command.add_flag("--line-numbers", options.line_numbers,
                     "G-code: write N1, N2, ... before every block");
    add_choice<bool>(command, "--comments", options.comments, yes_first,
                     "G-code: write name and cutter as comments (default yes)");
    add_whole_number(command,
                     {"--decimals",
                      "digits after the decimal point (default: the control's, 4 for "
                      "linuxcnc and APT)",
                      0, most_decimals},
                     [&options](int decimals) { options.decimals = decimals; })
        ->type_name("N");
}

}  // namespace

std::string word_of(PostFormat format)
{
    return std::string{word_for<PostFormat>(format, formats)};
}

std::string word_of(SingularRule rule)
{
    return std::string{word_for<SingularRule>(rule, singular_rules)};
}

std::string word_of(Coolant coolant)
{
    return std::string{word_for<Coolant>(coolant, coolants)};
}

void add_post_options(CLI::App& command, PostOptions& options)
{
    add_path_options(command, options.path);
    add_choice<PostFormat>(command, "--format", options.format, formats,
                           "language of the program (default gcode)");
    add_feed_options(command, options);
    add_tools_options(command, options.path);
    add_reading_options(command, options.path);
    add_machine_options(command, options);
    add_rotary_post_options(command, options);
    add_motion_options(command, options);
    add_text_options(command, options);
    add_common_options(command, options.common);
}

Control chosen_control(const PostOptions& options)
{
    std::vector<std::string_view> words;
    for (const BuiltInControl& control : built_in_controls) {
        if (control.word == options.control)
            return parse_control(control.content, options.control + ".json");
        words.push_back(control.word);
    }
    std::error_code ignored;
    if (!std::filesystem::exists(options.control, ignored))
        throw DomainError{"--control: found \"" + printable(options.control) +
                          "\", which is no file; expected a control file, " +
                          one_of(words, options.control)};
    return read_control(options.control, options.common.limits);
}

std::set<std::string> program_extensions()
{
    std::set<std::string> extensions{".apt"};
    for (const BuiltInControl& control : built_in_controls)
        extensions.insert(parse_control(control.content, "").extension);
    return extensions;
}

void refuse_idle_post_options(const PostOptions& options)
{
    const std::string found = "--format " + word_of(options.format);
    if (options.format == PostFormat::Gcode)
        refuse_idle_options(options.common, std::array{"--multax"}, found,
                            "--format apt");
    else
        refuse_idle_options(
            options.common,
            std::array{"--control", "--coolant", "--dwell-s", "--safe-height",
                       "--tool-number", "--lead-in", "--ramp-angle-deg",
                       "--approach-distance", "--arcs", "--arc-fit-tolerance", "--units",
                       "--line-numbers", "--comments"},
            found, "--format gcode");
    if (options.path.rotary.machine.empty())
        refuse_idle_options(
            options.common,
            std::array{"--tool", "--tolerance", "--angle-decimals", "--retract",
                       "--rapid-feed", "--blend", "--singular", "--singular-cone-deg"},
            "no --machine", "--machine");
    else
        refuse_idle_options(options.common,
                            std::array{"--arcs", "--lead-in", "--approach-distance"},
                            "--machine", "a program without rotary axes");
    if (options.machine.singular == SingularRule::Exact)
        refuse_idle_options(options.common, std::array{"--singular-cone-deg"},
                            "--singular exact", "--singular turn");
    if (options.lead_in == LeadIn::Straight)
        refuse_idle_options(options.common, std::array{"--ramp-angle-deg"},
                            "--lead-in straight", "--lead-in ramp");
    if (!options.arcs)
        refuse_idle_options(options.common, std::array{"--arc-fit-tolerance"},
                            "no --arcs", "--arcs");
}

void require_possible(const PostOptions& options, const Control& control)
{
    const auto require_words = [&](bool has_words, const std::string& option,
                                   const std::string& what) {
        if (!has_words)
            throw DomainError{option + ": the control " + control.name + " has no " +
                              what + "; expected a control that has it, or no " + option};
    };
    const bool wants_dwell = options.dwell_s.value_or(0) > 0;
    require_words(!wants_dwell || control.dwell, "--dwell-s", "dwell");
    require_words(!options.arcs || control.arcs != ArcForm::None, "--arcs", "arcs");
    require_words(options.coolant != Coolant::Flood || control.flood, "--coolant flood",
                  "flood coolant");
    require_words(options.coolant != Coolant::Mist || control.mist, "--coolant mist",
                  "mist coolant");
    if (!control.tool_change && !control.tool_length)
        refuse_idle_options(options.common, std::array{"--tool-number"},
                            "the control " + control.name,
                            "a control with a tool change");
}

}  // namespace endmill
