// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/machine_summary.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "cli/named_texts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/machine/feasible_directions.h"

namespace endmill {
namespace {

constexpr const char* at_example = "c=-40,a=25";

double degrees_of(double radians)
{
    return Angle::radians(radians).written_degrees();
}

Json shown_range(const RotaryRange& range)
{
    return {degrees_of(range.from), degrees_of(range.to)};
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

// The limits of the axis positions, as a machine file states them.
Json position_limits(const Machine& machine)
{
    Json limits = Json::object();
    const MachineConfiguration& configuration = machine.configuration;
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k) {
        const RotaryRange range = machine.wide_positions[k].value_or(mirrored(
            configuration.rotary[k].side, turns_of(machine.rotary, configuration, k)));
        limits[std::string{configuration.rotary[k].letter} + "_deg"] = shown_range(range);
    }
    return limits;
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
                degrees_of(solution.positions[k]);
        one["phi_deg"] = degrees_of(solution.angles.phi);
        one["theta_deg"] = degrees_of(solution.angles.theta);
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
    summary["position_limits"] =
        machine.configuration.is_valid() ? position_limits(machine) : Json{};
    summary["axis_offset_mm"] = shown_vector(machine.axis_offset);
    if (!machine.configuration.is_valid())
        return summary;
    if (!options.at.empty())
        add_location(summary, machine, options);
    if (options.inverse)
        add_solutions(summary, machine, options);
    return summary;
}

namespace {

std::string with_unit(const Json& range)
{
    return fmt::format("{} to {} degrees", shown_degrees(range[0].get<double>()),
                       shown_degrees(range[1].get<double>()));
}

std::string vector_text(const Json& vector)
{
    return fmt::format("({}, {}, {})", shown(vector[0].get<double>()),
                       shown(vector[1].get<double>()), shown(vector[2].get<double>()));
}

// "W/caxyBz/T is a valid 5-axis machine: C (R1) and A (R2) turn the part."
std::string kind_text(const Json& s)
{
    std::string text =
        fmt::format("{} is a valid {}-axis machine",
                    s["configuration"].get<std::string>(), s["axes"].get<int>());
    const Json& sides = s["sides"];
    if (sides.empty())
        return text + ": its tool always points along +z.\n";
    text += ": " + s["r1"].get<std::string>();
    if (sides.size() == 1)
        return text + " turns the " + sides[0].get<std::string>() + ".\n";
    if (sides[0] == sides[1])
        return text + fmt::format(" (R1) and {} (R2) turn the {}.\n",
                                  s["r2"].get<std::string>(),
                                  sides[0].get<std::string>());
    return text + fmt::format(" (R1) turns the {}, {} (R2) the {}.\n",
                              sides[0].get<std::string>(), s["r2"].get<std::string>(),
                              sides[1].get<std::string>());
}

// The limits of the positions, the turns of the tool and the share of all directions.
std::string reach_text(const Json& s)
{
    if (s["sides"].empty())
        return {};
    std::string text;
    for (const auto& [key, range] : s["position_limits"].items())
        text += fmt::format("{}{} from {}", text.empty() ? "Axis positions: " : ", ",
                            key.substr(0, 1), with_unit(range));
    text += ".\nTool against part: phi from " + with_unit(s["phi_range_deg"]);
    if (s["sides"].size() == 2)
        text += ", theta from " + with_unit(s["theta_range_deg"]);
    const double share = s["solid_angle_sr"].get<double>() / (4 * std::numbers::pi);
    return text + (s["sides"].size() == 2
                       ? fmt::format(": {} % of all directions.\n", shown(100 * share))
                       : std::string{": an arc of directions.\n"});
}

// "azimuth 45, polar angle 100 degrees"
std::string direction_text(const Vec3& direction)
{
    double azimuth = std::atan2(direction.y(), direction.x());
    if (azimuth < 0)
        azimuth += 2 * std::numbers::pi;
    const double polar = std::atan2(direction.head<2>().norm(), direction.z());
    return fmt::format("azimuth {}, polar angle {} degrees",
                       shown_degrees(Angle::radians(azimuth).degrees()),
                       shown_degrees(Angle::radians(polar).degrees()));
}

std::string within_text(const Json& is_within)
{
    return is_within.get<bool>() ? "within the limits" : "beyond the limits";
}

// "with X 1.2, Y 3, Z -4 mm, " if the axes have positions.
std::string xyz_text(const Json& xyz)
{
    if (xyz.is_null())
        return {};
    return fmt::format(" with X {}, Y {}, Z {} mm", shown(xyz[0].get<double>()),
                       shown(xyz[1].get<double>()), shown(xyz[2].get<double>()));
}

// "c 70, a -40 degrees"
std::string positions_text(const Json& solution)
{
    std::string text;
    for (const char* letter : {"a", "b", "c"}) {
        const auto found = solution.find(std::string{letter} + "_deg");
        if (found != solution.end())
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", letter,
                                shown_degrees(found->get<double>()));
    }
    return text.empty() ? "no rotary axis" : text + " degrees";
}

std::string inverse_text(const Json& s, const MachineOptions& options)
{
    const std::string direction = direction_text(options.inverse.value());
    if (s["inverse"].empty())
        return "No position gives " + direction + ".\n";
    std::string text;
    for (const Json& solution : s["inverse"])
        text += fmt::format("{} {}{}, {}",
                            text.empty() ? "Positions for " + direction + ":" : "; or",
                            positions_text(solution), xyz_text(solution["xyz_mm"]),
                            within_text(solution["within_limits"]));
    return text + ".\n";
}

}  // namespace

std::string machine_text(const Json& s, const MachineOptions& options)
{
    if (!s["valid"].get<bool>())
        return fmt::format("{} is not valid: {}.\n",
                           s["configuration"].get<std::string>(),
                           s["reason"].get<std::string>());
    std::string text = kind_text(s) + reach_text(s);
    for (std::size_t k = 0; k < options.contains.size(); ++k)
        text += fmt::format("The tool {} {}.\n",
                            s["contains"][k].get<bool>() ? "reaches" : "does not reach",
                            direction_text(options.contains[k]));
    if (s.contains("direction"))
        text += fmt::format("At {} the tool points along {}{}, {}.\n", options.at,
                            vector_text(s["direction"]), xyz_text(s["xyz_mm"]),
                            within_text(s["within_limits"]));
    if (s.contains("inverse"))
        text += inverse_text(s, options);
    if (s["axis_offset_mm"] != Json{0.0, 0.0, 0.0})
        text += fmt::format(
            "R2 is offset from R1 by {} mm; positions of X, Y and Z do not include the "
            "offset.\n",
            vector_text(s["axis_offset_mm"]));
    return text;
}

}  // namespace endmill
