// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_options.h"

#include <array>

#include "cli/arguments.h"
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
        "surface file (endmill-surface/1), or mesh (.stl, .obj, .ply, .off)");
    add_mesh_options(command, options.part);
    add_number(command,
               {"--chord-tolerance", "MM",
                "of the mesh that stands for a surface; default a thousandth of its "
                "longest side"},
               options.chord_tolerance);
    command
        .add_option("--points", options.points,
                    "directions to reach at the pole +z instead of a part: CSV "
                    "azimuth_deg,polar_deg")
        ->type_name("FILE");
}

void add_setup_machine(CLI::App& command, SetupCommandOptions& options)
{
    command
        .add_option("--machine", options.machine,
                    "axes from workpiece to tool with B the bed, such as W/caxyBz/T; a "
                    "file (endmill-machine/1); a folder of such files, of which each is "
                    "tried; or all, for those that come with endmill")
        ->type_name("MACHINE");
    add_choice<RotaryFamily>(command, "--family", options.family, rotary_families,
                             "instead of a machine: any of this family, R1 = A in AB");
    command.add_option("--limits", options.limits, rotary_limits_help)
        ->type_name("LIMITS");
    command
        .add_option_function<std::string>(
            "--clamp",
            [&options](const std::string& text) {
                options.clamp = vector_argument("--clamp", text);
            },
            "where the part's origin is put, in mm, in the machine's directions")
        ->type_name("X,Y,Z");
}

void add_setup_visibility(CLI::App& command, SetupCommandOptions& options)
{
    CLI::Option* sphere =
        command
            .add_option(
                "--sphere", options.sphere,
                "directions: hex:F, cube:F, latlong:NxM or ico:L; default hex:10, 1200 "
                "cells")
            ->type_name("GRID");
    CLI::Option* kind = add_choice<VisibilityKind>(
        command, "--visibility", options.visibility, visibility_kinds,
        "what blocks: other facets too, or the facet's own side alone");
    CLI::Option* incidence =
        add_number(command,
                   {"--incidence-deg", "DEG",
                    "largest angle between tool and normal, itself excluded",
                    NumberDomain::above_zero_to(90)},
                   options.incidence_deg);
    command
        .add_option("--tool", options.tool,
                    "tool file: shank and holder must stay clear of the part")
        ->type_name("FILE");
    command
        .add_option(
            "--from-visibility", options.from_visibility,
            "visibility.bsm of an earlier run for this part: no rays are cast, and it "
            "tells sphere, visibility and incidence")
        ->type_name("FILE")
        ->excludes(sphere)
        ->excludes(kind)
        ->excludes(incidence);
    command.add_flag("--write-bsm-csv", options.write_bsm_csv,
                     "write visibility.csv too: a row a facet, a column a cell, 0 = "
                     "accessible");
}

void add_setup_search(CLI::App& command, SetupCommandOptions& options)
{
    command
        .add_option_function<std::string>(
            "--mode",
            [&options](const std::string& word) {
                std::vector<std::string_view> words;
                words.reserve(setup_modes.size());
                for (const ModeChoice& choice : setup_modes)
                    words.push_back(choice.word);
                options.mode = setup_modes[choice_argument("--mode", word, words)].value;
            },
            "as the paper, its misprints corrected; as printed; exact for the nearest "
            "cells; over whole cones, with a certified bound")
        ->type_name("paper|paper-literal|corrected|set");
    add_choice<SetupObjective>(
        command, "--objective", options.objective, setup_objectives,
        "what --mode set has least of; the other modes minimise the area");
    add_number(command,
               {"--floor-deg", "DEG", "added to both ranges in the floored area",
                NumberDomain::from_to(1e-6, 360)},
               options.floor_deg);
    add_number(command,
               {"--gap", "SHARE", "of --mode set: stop so near to the certified bound"},
               options.gap);
    add_whole_number(command,
                     {"--max-nodes", "of --mode set: stop after so many; default 200000",
                      1, 100'000'000},
                     [&options](int nodes) { options.max_nodes = nodes; })
        ->type_name("N");
    add_whole_number(
        command, {"--max-setups", "look for up to so many setups; default 1", 1, 1000},
        [&options](int setups) { options.max_setups = setups; })
        ->type_name("N");
    add_number(command,
               {"--arc-tolerance-deg", "DEG",
                "of 4-axis machines: a cell counts so near to the arc",
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
