// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/machine_summary.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "cli/named_texts.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/machine/feasible_directions.h"

namespace endmill {
namespace {

constexpr const char* at_example = "c=-40,a=25";

double shown_degrees(double radians)
{
    return Angle::radians(radians).written_degrees();
}

Json shown_range(const RotaryRange& range)
{
    return {shown_degrees(range.from), shown_degrees(range.to)};
}

Json shown_vector(const Vec3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

Json capital(const MachineConfiguration& configuration, std::size_t axis)
{
    if (axis >= configuration.rotary.size())
        return nullptr;
    const int letter = std::toupper(configuration.rotary[axis].letter);
    return std::string{static_cast<char>(letter)};
}

Json family_word(const MachineConfiguration& configuration)
{
    if (configuration.family)
        return *configuration.family == RotaryFamily::CA ? "CA" : "AB";
    const bool is_four_axis = configuration.axes() == 4 && configuration.is_valid();
    return is_four_axis ? capital(configuration, 0) : Json{};
}

Json configuration_summary(const MachineConfiguration& configuration)
{
    Json sides = Json::array();
    for (const RotaryAxis& axis : configuration.rotary)
        sides.push_back(axis.side == MachineSide::Table ? "part" : "tool");
    const bool is_valid = configuration.is_valid();
    return {{"configuration", configuration.word},
            {"valid", is_valid},
            {"axes", configuration.axes()},
            {"family", family_word(configuration)},
            {"r1", capital(configuration, 0)},
            {"r2", capital(configuration, 1)},
            {"sides", sides},
            {"rank", configuration.rank},
            {"reason", is_valid ? Json{} : Json(why_not_valid(configuration))}};
}

void add_directions(Json& summary, const Machine& machine,
                    const std::vector<Vec3>& directions)
{
    const bool is_valid = machine.configuration.is_valid();
    summary["phi_range_deg"] = is_valid ? shown_range(machine.rotary.phi) : Json{};
    summary["theta_range_deg"] = is_valid ? shown_range(machine.rotary.theta) : Json{};
    summary["solid_angle_sr"] = 0;
    summary["contains"] = is_valid ? Json::array() : Json{};
    if (!is_valid)
        return;
    const FeasibleDirections feasible =
        feasible_directions(machine.configuration, machine.rotary);
    summary["solid_angle_sr"] = feasible.solid_angle();
    for (const Vec3& direction : directions)
        summary["contains"].push_back(feasible.contains(direction));
}

RotaryPositions positions_in(const std::string& text,
                             const MachineConfiguration& configuration)
{
    RotaryPositions positions{0, 0};
    std::set<std::string> given;
    for (const NamedText& item : named_texts("--at", text, at_example)) {
        const auto is_it = [&](const RotaryAxis& axis) {
            return item.name == std::string{axis.letter};
        };
        const auto axis = std::ranges::find_if(configuration.rotary, is_it);
        const auto degrees = number_from_text(item.text);
        constexpr double most_deg = 1e6;  // the limit of machine files, for endless axes
        const bool is_position = axis != configuration.rotary.end() && degrees &&
                                 std::abs(*degrees) <= most_deg &&
                                 given.insert(item.name).second;
        if (!is_position)
            throw DomainError{"--at: found \"" + printable(item.name + "=" + item.text) +
                              "\"; expected each rotary axis of " + configuration.word +
                              " at most once, with degrees up to a million, as in " +
                              at_example};
        positions[static_cast<std::size_t>(axis - configuration.rotary.begin())] =
            Angle::degrees(*degrees).radians();
    }
    return positions;
}

void add_location(Json& summary, const Machine& machine, const MachineOptions& options)
{
    const RotaryPositions rotary = positions_in(options.at, machine.configuration);
    const AxisPositions at = axis_positions(
        machine, rotary, options.point.value_or(Vec3::Zero()), options.length_mm);
    summary["direction"] =
        shown_vector(tool_location(machine, at, options.length_mm).axis);
    summary["xyz_mm"] = options.point ? shown_vector(at.xyz) : Json{};
    Machine turning = machine;
    if (!options.point)
        turning.linear = {};
    summary["within_limits"] = is_within_travel(turning, at);
}

void add_solutions(Json& summary, const Machine& machine, const MachineOptions& options)
{
    const MachineConfiguration& configuration = machine.configuration;
    summary["inverse"] = Json::array();
    for (const RotarySolution& solution :
         rotary_solutions(machine, options.inverse.value())) {
        Json one;
        for (std::size_t k = 0; k < configuration.rotary.size(); ++k)
            one[std::string{configuration.rotary[k].letter} + "_deg"] =
                shown_degrees(solution.positions[k]);
        one["phi_deg"] = shown_degrees(solution.angles.phi);
        one["theta_deg"] = shown_degrees(solution.angles.theta);
        bool is_within_limits = solution.is_within_limits;
        one["xyz_mm"] = nullptr;
        if (options.point) {
            const AxisPositions at = axis_positions(machine, solution.positions,
                                                    *options.point, options.length_mm);
            one["xyz_mm"] = shown_vector(at.xyz);
            is_within_limits = is_within_limits && is_within(machine.linear, at.xyz);
        }
        one["within_limits"] = is_within_limits;
        summary["inverse"].push_back(one);
    }
}

}  // namespace

Json machine_summary(const Machine& machine, const MachineOptions& options)
{
    Json summary = configuration_summary(machine.configuration);
    // Refuse wrong positions even if the machine is not valid.
    if (!options.at.empty())
        positions_in(options.at, machine.configuration);
    add_directions(summary, machine, options.contains);
    if (!machine.configuration.is_valid())
        return summary;
    if (!options.at.empty())
        add_location(summary, machine, options);
    if (options.inverse)
        add_solutions(summary, machine, options);
    return summary;
}

}  // namespace endmill
