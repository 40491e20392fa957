// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "endmill/core/angle.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/json_format.h"
#include "endmill/files/read_file.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"

// A machine file describes axes in the words of a machine builder: the travel of each
// axis by its name, in mm or degrees. Reading keeps this description
// (MachineDescription). `moving_machine` converts it to the kinematic model of the
// library, which has two rotary angles of the tool against the part, whatever axes
// produce them.

namespace endmill {
namespace {

constexpr std::string_view format_name = "endmill-machine/1";
constexpr std::string_view code = "E_MACHINE";
// Upper end for rpm, W, N m, mm/min and m/s^2: beyond every machine, and finite.
constexpr double most_of_all = 1e9;
constexpr double most_turn_deg = 1e6;  // beyond every axis that turns without end

// A key of `limits`, and its axis.
struct AxisKey {
    std::string_view key;
    char axis;
    bool is_rotary;
};

constexpr std::array<AxisKey, 6> axis_keys{{{"x_mm", 'x', false},
                                            {"y_mm", 'y', false},
                                            {"z_mm", 'z', false},
                                            {"a_deg", 'a', true},
                                            {"b_deg", 'b', true},
                                            {"c_deg", 'c', true}}};

// An error with the code of machine files.
FormatError machine_complaint(const JsonValue& value, const std::string& expected)
{
    return value.complaint(value.shown(), expected, std::string{code});
}

// The configuration word in the file, or `otherwise`.
std::string configuration(const JsonValue& root, const std::string& otherwise)
{
    const auto value = root.find_member("configuration");
    if (!value)
        return otherwise;
    std::string word = value->text();
    if (const auto fault = configuration_fault(word))
        throw value->complaint(
            value->shown() + ": " + *fault,
            "W/, the axes x, y, z, the bed B and at most two of a, b, c "
            "from workpiece to tool, /T, such as \"W/caxyBz/T\"",
            std::string{code});
    return word;
}

// Checks the limits of a rotary axis.
void require_rotary_range(const JsonValue& value, double from_deg, double to_deg)
{
    if (!(from_deg <= 0 && 0 <= to_deg))
        throw value.complaint("[" + to_text(from_deg) + ", " + to_text(to_deg) + "]",
                              "limits that hold 0, the lower one first",
                              std::string{code});
}

// The range of one axis: [min, max] in mm or degrees; the result is in mm or rad.
AxisTravel travel(const JsonValue& value, const AxisKey& key, const ReadLimits& limits)
{
    if (value.size() != 2)
        throw machine_complaint(value, "[min, max]");
    const double most = key.is_rotary ? most_turn_deg : limits.max_extent_mm;
    const NumberRange range{.above = -most, .most = most, .from = true, .code = code};
    const JsonValue first = value.item(0);
    const JsonValue last = value.item(1);
    const double from = number_in(first, range);
    const double to = number_in(last, range);
    if (!(from <= to))
        throw machine_complaint(last, "at least the min, " + to_text(from));
    if (!key.is_rotary)
        return {key.axis, from, to};
    require_rotary_range(value, from, to);
    return {key.axis, Angle::degrees(from).radians(), Angle::degrees(to).radians()};
}

// Number of an axis among the rotary axes, from the part to the tool; their count if it
// is not one of them.
std::size_t place_of(const MachineConfiguration& machine, char letter)
{
    const auto axis = std::ranges::find(machine.rotary, letter, &RotaryAxis::letter);
    return static_cast<std::size_t>(axis - machine.rotary.begin());
}

// The ranges of all axes in the order x, y, z, a, b, c.
std::vector<AxisTravel> travels(const JsonValue& root, std::string_view configuration,
                                const ReadLimits& limits)
{
    std::vector<AxisTravel> all;
    const auto value = root.find_member("limits");
    if (!value)
        return all;
    std::vector<std::string_view> keys;
    keys.reserve(axis_keys.size());
    for (const AxisKey& key : axis_keys)
        keys.push_back(key.key);
    value->allow_only(keys);
    for (const AxisKey& key : axis_keys) {
        const auto found = value->find_member(key.key);
        if (!found)
            continue;
        if (configuration.find(key.axis) == std::string_view::npos)
            throw found->complaint("limits of an axis that the machine does not have",
                                   "one of " + std::string{configuration},
                                   std::string{code});
        all.push_back(travel(*found, key, limits));
    }
    return all;
}

// An error for a key of an axis that the machine lacks.
FormatError missing_axis(const JsonValue& value, const std::string& what,
                         std::string_view configuration)
{
    return value.complaint(what + " of an axis that the machine does not have",
                           "an axis of " + std::string{configuration}, std::string{code});
}

// The signs of words in programs, in the order a, b, c.
std::vector<WordSign> word_signs(const JsonValue& root, std::string_view configuration)
{
    constexpr std::array<std::string_view, 3> letters{"a", "b", "c"};
    std::vector<WordSign> signs;
    const auto value = root.find_member("word_sign");
    if (!value)
        return signs;
    value->allow_only(letters);
    for (const std::string_view letter : letters) {
        const auto found = value->find_member(letter);
        if (!found)
            continue;
        if (configuration.find(letter) == std::string_view::npos)
            throw missing_axis(*found, "sign", configuration);
        const double sign =
            number_in(*found, {.above = -1, .most = 1, .from = true, .code = code});
        if (sign != 1 && sign != -1)
            throw machine_complaint(*found, "1 or -1");
        signs.push_back({letter.front(), static_cast<int>(sign)});
    }
    return signs;
}

// Largest speeds of single axes, in the order x, y, z, a, b, c.
std::vector<AxisRate> axis_rates(const JsonValue& root, std::string_view configuration)
{
    constexpr std::array<std::string_view, 6> keys{"x_mm_per_min",  "y_mm_per_min",
                                                   "z_mm_per_min",  "a_deg_per_min",
                                                   "b_deg_per_min", "c_deg_per_min"};
    std::vector<AxisRate> rates;
    const auto value = root.find_member("max_rate");
    if (!value)
        return rates;
    value->allow_only(keys);
    for (const std::string_view key : keys) {
        const auto found = value->find_member(key);
        if (!found)
            continue;
        const char axis = key.front();
        if (configuration.find(axis) == std::string_view::npos)
            throw missing_axis(*found, "rate", configuration);
        const double rate =
            number_in(*found, {.above = 0, .most = most_of_all, .code = code});
        const bool is_linear = axis >= 'x';
        rates.push_back({axis, is_linear ? rate : Angle::degrees(rate).radians()});
    }
    return rates;
}

// Limits of the spindle and the feed drives; each is optional.
MachineLimits machine_limits(const JsonValue& root)
{
    constexpr std::array<std::string_view, 3> keys{"max_rpm", "max_power_w",
                                                   "max_torque_n_m"};
    constexpr NumberRange range{.above = 0, .most = most_of_all, .code = code};
    MachineLimits limits;
    if (const auto spindle = root.find_member("spindle")) {
        spindle->allow_only(keys);
        limits.max_rpm = find_number(*spindle, keys[0], range);
        limits.max_power_w = find_number(*spindle, keys[1], range);
        limits.max_torque_n_m = find_number(*spindle, keys[2], range);
    }
    limits.max_feed_mm_per_min = find_number(root, "max_feed_mm_per_min", range);
    limits.acceleration_m_per_s2 = find_number(root, "acceleration_m_per_s2", range);
    return limits;
}

// An offset, an array of three lengths.
std::optional<Vec3> offset(const JsonValue& root, std::string_view key, double most)
{
    const auto value = root.find_member(key);
    if (!value)
        return std::nullopt;
    if (value->size() != 3)
        throw machine_complaint(*value, "[x, y, z]");
    Vec3 offset;
    for (std::size_t k = 0; k < 3; ++k) {
        const JsonValue item = value->item(k);
        offset[static_cast<Eigen::Index>(k)] =
            number_in(item, {.above = -most, .most = most, .from = true, .code = code});
    }
    return offset;
}

// The offset between the lines of two rotary axes, of which one carries the other.
std::optional<Vec3> axis_offset(const JsonValue& root, const std::string& configuration,
                                double most)
{
    constexpr std::string_view key = "axis_offset_mm";
    const std::optional<Vec3> found = offset(root, key, most);
    const auto rotary = configuration_from_word(configuration).rotary;
    const bool has_neighbours = rotary.size() == 2 && rotary[0].side == rotary[1].side;
    if (found && !has_neighbours)
        throw root.find_member(key)->complaint(
            "an offset between the rotary axes of " + configuration,
            "a machine with two rotary axes on one side of the bed", std::string{code});
    return found;
}

}  // namespace

MachineDescription read_machine(const std::filesystem::path& path,
                                const ReadLimits& limits)
{
    return parse_machine(read_file(path, limits), path, limits);
}

MachineDescription parse_machine(std::string_view content,
                                 const std::filesystem::path& path,
                                 const ReadLimits& limits)
{
    constexpr std::array<std::string_view, 13> keys{"format",
                                                    "name",
                                                    "source",
                                                    "configuration",
                                                    "limits",
                                                    "pivot_mm",
                                                    "table_offset_mm",
                                                    "axis_offset_mm",
                                                    "word_sign",
                                                    "max_rate",
                                                    "spindle",
                                                    "max_feed_mm_per_min",
                                                    "acceleration_m_per_s2"};
    const FormatDocument document{content, path, limits, format_name};
    const JsonValue root = document.root();
    root.allow_only(keys);

    const double most = limits.max_extent_mm;
    MachineDescription machine{.name = name_or_stem(root, path),
                               .source = remark(root, "source")};
    machine.configuration = configuration(root, machine.configuration);
    machine.limits = machine_limits(root);
    machine.travels = travels(root, machine.configuration, limits);
    machine.pivot_mm = find_number(
        root, "pivot_mm", {.above = -most, .most = most, .from = true, .code = code});
    machine.table_offset_mm = offset(root, "table_offset_mm", most);
    machine.axis_offset_mm = axis_offset(root, machine.configuration, most);
    machine.word_signs = word_signs(root, machine.configuration);
    machine.rates = axis_rates(root, machine.configuration);
    return machine;
}

namespace {

// The largest speeds of the axes of a machine.
AxisRates rates_of(const MachineDescription& description,
                   const MachineConfiguration& configuration)
{
    AxisRates rates{.feed_mm_per_min = description.limits.max_feed_mm_per_min};
    for (const AxisRate& rate : description.rates)
        if (rate.axis >= 'x')
            rates.linear_mm_per_min[static_cast<std::size_t>(rate.axis - 'x')] =
                rate.per_min;
        else
            rates.rotary_rad_per_min[place_of(configuration, rate.axis)] = rate.per_min;
    return rates;
}

}  // namespace

// The file has positions of the axes. The kinematic model has turns of the tool against
// the part, so ranges of axes that carry the part are mirrored. Directions repeat after a
// full rotation, so that wider ranges are reduced to one. A range of at least a full
// rotation is kept beside, because a model without it has no limits.
Machine moving_machine(const MachineDescription& description)
{
    Machine machine{.configuration = configuration_from_word(description.configuration),
                    .pivot = description.pivot_mm.value_or(0),
                    .table_offset = description.table_offset_mm.value_or(Vec3::Zero()),
                    .axis_offset = description.axis_offset_mm.value_or(Vec3::Zero())};
    machine.rotary = widest_limits(machine.configuration);
    machine.rates = rates_of(description, machine.configuration);
    for (const WordSign& sign : description.word_signs)
        machine.word_signs[place_of(machine.configuration, sign.axis)] = sign.sign;
    for (const AxisTravel& travel : description.travels) {
        if (travel.axis >= 'x') {
            machine.linear[static_cast<std::size_t>(travel.axis - 'x')] = {travel.from,
                                                                           travel.to};
            continue;
        }
        const std::size_t place = place_of(machine.configuration, travel.axis);
        if (!machine.configuration.is_valid())
            continue;
        const RotaryRange turns = mirrored(machine.configuration.rotary[place].side,
                                           RotaryRange{travel.from, travel.to});
        const RotaryRange used = within_one_rotation(place, turns);
        turns_of(machine.rotary, machine.configuration, place) = used;
        const bool is_full = turns.to - turns.from >= 2 * std::numbers::pi;
        if (used != turns || is_full)
            machine.wide_positions[place] = RotaryRange{travel.from, travel.to};
    }
    return machine;
}

}  // namespace endmill
