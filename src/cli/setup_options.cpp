// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_options.h"

#include <array>

#include "cli/arguments.h"
#include "cli/facet_list.h"
#include "cli/rotary_limits_option.h"

namespace endmill {
namespace {

using ModeChoice = Choice<SetupMode>;

constexpr std::array setup_modes{ModeChoice{"paper", SetupMode::Paper},
                                 ModeChoice{"paper-literal", SetupMode::PaperLiteral},
                                 ModeChoice{"corrected", SetupMode::Corrected},
                                 ModeChoice{"set", SetupMode::WholeCones}};

constexpr std::array setup_objectives{
    Choice<SetupObjective>{"floored-area", SetupObjective::FlooredArea},
    Choice<SetupObjective>{"total-range", SetupObjective::TotalRange},
    Choice<SetupObjective>{"tilt", SetupObjective::Tilt}};

constexpr std::array visibility_kinds{
    Choice<VisibilityKind>{"global", VisibilityKind::Global},
    Choice<VisibilityKind>{"local", VisibilityKind::Local}};

constexpr std::array rotary_families{Choice<RotaryFamily>{"CA", RotaryFamily::CA},
                                     Choice<RotaryFamily>{"AB", RotaryFamily::AB}};

void add_setup_part(CLI::App& command, SetupCommandOptions& options)
{
    command.add_option(
        "PART", options.part.path,
        "surface file (endmill-surface/1), mesh (.stl, .obj, .ply, .off), or CAD file "
        "(.step, .stp, .iges, .igs)");
    add_mesh_options(command, options.part);
    add_skip_facets_option(command, options.skip_facets,
                           "they need not be accessible, but hide others. Facets of a "
                           "surface are those of its mesh");
    add_number(command,
               {"--chord-tolerance", "MM",
                "largest distance from a surface to its mesh (default: longest side / "
                "1000)"},
               options.chord_tolerance);
    command
        .add_option("--points", options.points,
                    "directions to reach, in place of PART; the tool axis is +z (CSV: "
                    "azimuth_deg, polar_deg)")
        ->type_name("FILE");
    command
        .add_option("--path", options.toolpath,
                    "tool path that the machine is to run, in place of PART: find a "
                    "rotation of the part and a clamping position for post --setup")
        ->type_name("TOOLPATH");
}

void add_setup_machine(CLI::App& command, SetupCommandOptions& options)
{
    command
        .add_option("--machine", options.machine,
                    "axes from workpiece to tool with B the bed, such as W/caxyBz/T; a "
                    "file (endmill-machine/1); a folder of machine files; or all: every "
                    "machine supplied with endmill")
        ->type_name("MACHINE");
    add_choice<RotaryFamily>(
        command, "--family", options.family, rotary_families,
        "family of rotary axes, in place of a machine (AB: R1 is A)");
    command.add_option("--limits", options.limits, rotary_limits_help)
        ->type_name("LIMITS");
    command
        .add_option_function<std::string>(
            "--clamp",
            [&options](const std::string& text) {
                options.clamp = vector_argument("--clamp", text);
            },
            "position of the part's origin in mm, along the machine's axes (default "
            "0,0,0; with --within-travel the best position)")
        ->type_name("X,Y,Z");
    command.add_flag_callback(
        "--within-travel", [&options] { options.travel = TravelRule::WithinLimits; },
        "find only a pose that the linear axes of the machine file reach, and its best "
        "clamping position; or state by how much the nearest pose exceeds the travel");
}

void add_setup_visibility(CLI::App& command, SetupCommandOptions& options)
{
    CLI::Option* sphere =
        command
            .add_option(
                "--sphere", options.sphere,
                "grid of directions: hex:F, cube:F, latlong:NxM or ico:L (default "
                "hex:10, 1200 cells)")
            ->type_name("GRID");
    CLI::Option* kind = add_choice<VisibilityKind>(
        command, "--visibility", options.visibility, visibility_kinds,
        "global (default): other facets can hide a facet; local: only its own normal "
        "counts");
    CLI::Option* incidence = add_number(
        command,
        {"--incidence-deg", "DEG",
         "a facet is accessible only below this angle between tool axis and facet "
         "normal",
         NumberDomain::above_zero_to(90)},
        options.incidence_deg);
    command
        .add_option("--tool", options.tool,
                    "tool file: its shank and holder must stay clear of the part")
        ->type_name("FILE");
    command
        .add_option("--from-visibility", options.from_visibility,
                    "visibility.bsm of an earlier run of this part, in place of a new "
                    "computation")
        ->type_name("FILE")
        ->excludes(sphere)
        ->excludes(kind)
        ->excludes(incidence);
    command.add_flag(
        "--write-bsm-csv", options.write_bsm_csv,
        "write visibility.csv: a row for each facet, a column for each cell, "
        "0 = accessible");
}

void add_setup_search(CLI::App& command, SetupCommandOptions& options)
{
    add_choice<SetupMode>(
        command, "--mode", options.mode, setup_modes,
        "paper (default): as published, misprints corrected; paper-literal: as printed; "
        "corrected: the exact optimum for tool axes at cell centres, with one cell for "
        "each cone; set: minimises --objective over whole cones, with a lower bound");
    add_choice<SetupObjective>(command, "--objective", options.objective,
                               setup_objectives,
                               "quantity to minimise (default floored-area; --mode set "
                               "only)");
    add_number(command,
               {"--floor-deg", "DEG",
                "f in the floored area (w + f)(h + f) of the two rotary ranges w and h",
                NumberDomain::from_to(1e-6, 360)},
               options.floor_deg);
    add_number(command,
               {"--gap", "SHARE",
                "stop when the result is within this share of the lower bound (--mode "
                "set only)"},
               options.gap);
    add_whole_number(command,
                     {"--max-nodes",
                      "largest number of search nodes (default 200000; --mode set only)",
                      1, 100'000'000},
                     [&options](int nodes) { options.max_nodes = nodes; })
        ->type_name("N");
    add_whole_number(
        command,
        {"--max-setups",
         "largest number of setups to combine until every facet is reachable (default 1)",
         1, 1000},
        [&options](int setups) { options.max_setups = setups; })
        ->type_name("N");
    add_number(command,
               {"--arc-tolerance-deg", "DEG",
                "4-axis machine: a cell counts as reached within this angle of the arc "
                "of tool directions",
                NumberDomain::from_to(0, 45)},
               options.arc_tolerance_deg);
}

}  // namespace

void add_setup_options(CLI::App& command, SetupCommandOptions& options)
{
    add_setup_part(command, options);
    add_setup_machine(command, options);
    add_setup_visibility(command, options);
    add_setup_search(command, options);
    add_html_option(command, options.common);
    add_common_options(command, options.common);
}

std::string_view setup_mode_word(SetupMode mode)
{
    return word_for<SetupMode>(mode, setup_modes);
}

std::string_view setup_objective_word(SetupObjective objective)
{
    return word_for<SetupObjective>(objective, setup_objectives);
}

std::string_view visibility_word(VisibilityKind kind)
{
    return word_for<VisibilityKind>(kind, visibility_kinds);
}

}  // namespace endmill
