// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/machine_options.h"

#include <cmath>

#include "cli/arguments.h"
#include "cli/named_texts.h"
#include "cli/rotary_limits_option.h"
#include "endmill/core/angle.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// The unit vector of "AZIMUTH,POLAR" in degrees.
Vec3 spherical_argument(const std::string& option, const std::string& text)
{
    const std::vector<std::string> parts = parts_of(text, ',');
    const auto azimuth_deg = number_from_text(parts.front());
    const auto polar_deg = number_from_text(parts.back());
    const bool is_direction = parts.size() == 2 && azimuth_deg && polar_deg &&
                              *polar_deg >= 0 && *polar_deg <= 180;
    if (!is_direction)
        throw CLI::ValidationError(option,
                                   "found \"" + printable(text) +
                                       "\"; expected AZIMUTH,POLAR in degrees, the "
                                       "polar angle from 0 to 180");
    const double azimuth = Angle::degrees(std::remainder(*azimuth_deg, 360)).radians();
    const double polar = Angle::degrees(*polar_deg).radians();
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
            std::cos(polar)};
}

void add_contains(CLI::App& command, std::vector<Vec3>& contains)
{
    command
        .add_option_function<std::vector<std::string>>(
            "--contains",
            [&contains](const std::vector<std::string>& directions) {
                for (const std::string& text : directions)
                    contains.push_back(spherical_argument("--contains", text));
            },
            "report whether the tool reaches this direction, in degrees; may be repeated")
        ->type_name("AZ,POL")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

void add_machine_options(CLI::App& command, MachineOptions& options)
{
    command
        .add_option(
            "MACHINE", options.machine,
            "axes from workpiece to tool with B the bed, such as W/caxyBz/T, or a "
            "file (endmill-machine/1)")
        ->required();
    command.add_option("--limits", options.limits, rotary_limits_help)
        ->type_name("LIMITS");
    add_contains(command, options.contains);
    command
        .add_option("--at", options.at,
                    "positions of rotary axes in degrees, such as c=-40,a=25 (others 0)")
        ->type_name("POSITIONS");
    command
        .add_option_function<std::string>(
            "--inverse",
            [&options](const std::string& text) {
                options.inverse = spherical_argument("--inverse", text);
            },
            "report the positions that give this direction, in degrees")
        ->type_name("AZ,POL");
    command
        .add_option_function<std::string>(
            "--point",
            [&options](const std::string& text) {
                options.point = vector_argument("--point", text);
            },
            "point of the part for the tip, in mm (with --at or --inverse)")
        ->type_name("X,Y,Z");
    add_number(command,
               {"--length", "MM", "length of the tool, from spindle to tip",
                NumberDomain::from_zero()},
               options.length_mm);
    add_common_options(command, options.common);
}

}  // namespace endmill
