// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_value.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/json_format.h"

namespace endmill {
namespace {

constexpr int most_flutes = 100;  // beyond every end mill
constexpr double right_angle_deg = 90;

// The cutter that the cutter word describes.
Cutter cutter(const JsonValue& root)
{
    const JsonValue value = root.member("cutter");
    if (const auto cutter = cutter_from_word(value.text()))
        return *cutter;
    throw value.complaint(value.shown(), expected_cutter(value.text()));
}

// A number above 0, at most `most`.
double positive(const JsonValue& value, double most)
{
    return number_in(value, {.above = 0, .most = most});
}

// A number from 0 to `most`.
double not_negative(const JsonValue& value, double most)
{
    return number_in(value, {.above = 0, .most = most, .from = true});
}

// A cylinder of the shank or holder; its upper end must be above its lower end.
ToolCylinder cylinder(const JsonValue& value, double most_mm)
{
    constexpr std::array<std::string_view, 3> keys{"diameter_mm", "from_mm", "to_mm"};
    value.allow_only(keys);
    const double from = not_negative(value.member("from_mm"), most_mm);
    const double to = positive(value.member("to_mm"), most_mm);
    if (!(from < to))
        throw value.member("to_mm").complaint(value.member("to_mm").shown(),
                                              "a number above from_mm, " + to_text(from));
    return {positive(value.member("diameter_mm"), most_mm), from, to};
}

// The cylinders under `key`; none if the key is missing.
std::vector<ToolCylinder> cylinders(const JsonValue& root, std::string_view key,
                                    double most_mm)
{
    std::vector<ToolCylinder> all;
    if (const auto list = root.find_member(key))
        for (std::size_t k = 0; k < list->size(); ++k)
            all.push_back(cylinder(list->item(k), most_mm));
    return all;
}

// The loads that the tool bears; each is optional.
LoadLimits tool_limits(const JsonValue& root)
{
    constexpr std::array<std::string_view, 3> keys{"cutting_force_n", "thrust_n",
                                                   "torque_n_m"};
    constexpr double most = 1e9;  // N or N m: beyond every tool, and finite
    LoadLimits limits;
    const auto value = root.find_member("limits");
    if (!value)
        return limits;
    value->allow_only(keys);
    const auto limit = [&](std::string_view key) -> std::optional<double> {
        const auto found = value->find_member(key);
        return found ? std::optional{positive(*found, most)} : std::nullopt;
    };
    return {limit(keys[0]), limit(keys[1]), limit(keys[2])};
}

// The helix angle, between -90 and 90 degrees; nothing if it is not stated.
std::optional<Angle> helix(const JsonValue& root)
{
    const auto value = root.find_member("helix_deg");
    if (!value)
        return std::nullopt;
    const double degrees = value->number();
    if (!(degrees > -right_angle_deg && degrees < right_angle_deg))
        throw value->complaint(value->shown(), "an angle between -90 and 90 degrees");
    return Angle::degrees(degrees);
}

// The length of the cutting edges, which hold at least the rounded corner; infinite if it
// is not stated.
double cutting_length(const JsonValue& root, const Cutter& cutter, double most)
{
    const auto value = root.find_member("cutting_length_mm");
    if (!value)
        return std::numeric_limits<double>::infinity();
    const double length = positive(*value, most);
    if (length < cutter.corner_radius())
        throw value->complaint(value->shown(),
                               "at least the corner radius of the cutter, " +
                                   to_text(cutter.corner_radius()) + " mm");
    return length;
}

}  // namespace

Tool tool_in(const JsonValue& root, const ReadLimits& limits)
{
    constexpr std::array<std::string_view, 11> keys{
        "format",    "name",   "source", "cutter", "flutes",           "helix_deg",
        "length_mm", "limits", "shank",  "holder", "cutting_length_mm"};
    root.allow_only(keys);
    Tool tool{.cutter = cutter(root)};
    tool.name = remark(root, "name");
    remark(root, "source");  // not stored; this checks that it is a text
    if (const auto flutes = root.find_member("flutes"))
        tool.flutes = static_cast<int>(flutes->whole_number(1, most_flutes));
    tool.helix = helix(root);
    if (const auto length = root.find_member("length_mm"))
        tool.length = not_negative(*length, limits.max_extent_mm);
    tool.cutting_length = cutting_length(root, tool.cutter, limits.max_extent_mm);
    tool.limits = tool_limits(root);
    tool.shank = cylinders(root, "shank", limits.max_extent_mm);
    tool.holder = cylinders(root, "holder", limits.max_extent_mm);
    return tool;
}

}  // namespace endmill
