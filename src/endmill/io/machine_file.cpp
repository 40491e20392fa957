// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/machine_file.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "endmill/core/angle.h"
#include "endmill/core/numbers.h"
#include "endmill/io/json_format.h"
#include "endmill/io/read_file.h"

namespace endmill {
namespace {

constexpr std::string_view format_name = "endmill-machine/1";
constexpr std::string_view code = "E_MACHINE";
constexpr double most_of_all = 1e9;    // rpm, W, N m, mm/min, m/s^2: any machine's
constexpr double most_turn_deg = 1e6;  // a rotary axis that turns for ever

// Of the keys in `limits`: the axis and its unit.
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

FormatError machine_complaint(const JsonValue& value, const std::string& expected)
{
    return value.complaint(value.shown(), expected, std::string{code});
}

// From workpiece to tool: x, y, z and the bed B once each, a, b, c at most once.
bool is_configuration(std::string_view word)
{
    if (!word.starts_with("W/") || !word.ends_with("/T") || word.size() < 4)
        return false;
    const std::string_view axes = word.substr(2, word.size() - 4);
    const auto count = [&](char letter) { return std::ranges::count(axes, letter); };
    std::size_t known = 0;
    for (const char letter : std::string_view{"xyzB"}) {
        if (count(letter) != 1)
            return false;
        ++known;
    }
    for (const char letter : std::string_view{"abc"}) {
        if (count(letter) > 1)
            return false;
        known += static_cast<std::size_t>(count(letter));
    }
    return known == axes.size();
}

std::string configuration(const JsonValue& root, const std::string& otherwise)
{
    const auto value = root.find_member("configuration");
    if (!value)
        return otherwise;
    const std::string word = value->text();
    if (!is_configuration(word))
        throw machine_complaint(*value,
                                "W/, the axes x, y, z, the bed B and any of a, b, c from "
                                "workpiece to tool, /T, such as \"W/xyBz/T\"");
    return word;
}

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
    return {key.axis, Angle::degrees(from).radians(), Angle::degrees(to).radians()};
}

std::vector<AxisTravel> travels(const JsonValue& root, std::string_view configuration,
                                const ReadLimits& limits)
{
    std::vector<AxisTravel> all;
    const auto value = root.find_member("limits");
    if (!value)
        return all;
    std::vector<std::string_view> keys;
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

std::optional<Vec3> table_offset(const JsonValue& root, double most)
{
    const auto value = root.find_member("table_offset_mm");
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
    constexpr std::array<std::string_view, 10> keys{"format",
                                                    "name",
                                                    "source",
                                                    "configuration",
                                                    "limits",
                                                    "pivot_mm",
                                                    "table_offset_mm",
                                                    "spindle",
                                                    "max_feed_mm_per_min",
                                                    "acceleration_m_per_s2"};
    const FormatDocument document{content, path, limits, {format_name, keys}};
    const JsonValue root = document.root();

    const double most = limits.max_extent_mm;
    MachineDescription machine{.name = name_or_stem(root, path),
                               .source = remark(root, "source")};
    machine.configuration = configuration(root, machine.configuration);
    machine.limits = machine_limits(root);
    machine.travels = travels(root, machine.configuration, limits);
    machine.pivot_mm = find_number(
        root, "pivot_mm", {.above = -most, .most = most, .from = true, .code = code});
    machine.table_offset_mm = table_offset(root, most);
    return machine;
}

}  // namespace endmill
