// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/surface_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/io/file_format.h"
#include "endmill/io/printable.h"
#include "endmill/io/read_file.h"
#include "endmill/io/strict_json.h"

namespace endmill {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view format_family = "endmill-surface/";
constexpr int format_version = 1;
constexpr std::int64_t most_patches = 10000;
constexpr double mm_per_inch = 25.4;
constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_source = 2000;

constexpr std::array<std::string_view, 10> bezier_keys{
    "format",    "name",      "source",    "type",           "units",
    "tool_side", "patches_u", "patches_v", "control_points", "trim_loops"};

// A net as the file holds it: rows of constant v, u running fastest.
struct ControlNet {
    std::int64_t patches_u;
    std::int64_t patches_v;
    std::vector<Vec3> points;

    std::int64_t columns() const { return 3 * patches_u + 1; }
    std::int64_t rows() const { return 3 * patches_v + 1; }
};

// Tells a mesh or a program from a surface before complaining of its syntax.
void check_content(std::string_view content, const std::string& file)
{
    const auto format = recognized_format(content);
    if (format == "JSON")
        return;
    const std::string found =
        format ? "content looks like " + std::string{*format} : "content is not JSON";
    throw FormatError{"E_FORMAT",
                      {file, "", found, "JSON of format \"endmill-surface/1\""}};
}

// The version that follows `format_family`, if it is a number.
std::optional<double> version_of(std::string_view format)
{
    if (!format.starts_with(format_family))
        return std::nullopt;
    return number_from_text(format.substr(format_family.size()));
}

// First of all keys, since a newer version may have others.
void check_format(const JsonValue& root)
{
    const JsonValue value = root.member("format");
    const std::string format = value.text();
    if (format == std::string{format_family} + std::to_string(format_version))
        return;
    const std::string expected = "\"endmill-surface/1\"";
    if (const auto version = version_of(format); version && *version > format_version)
        throw value.complaint("made by a newer version: " + value.shown(), expected);
    throw value.complaint(value.shown(), expected, "E_FORMAT");
}

void check_type(const JsonValue& root)
{
    constexpr std::array<std::string_view, 4> types{"bezier", "nurbs", "bezier-patches",
                                                    "height-grid"};
    const JsonValue value = root.member("type");
    const std::string_view type = value.word(types);
    if (type != "bezier")
        throw value.complaint("surfaces of type \"" + std::string{type} +
                                  "\" are not supported by this version",
                              "\"bezier\"", "E_SURFACE");
    if (const auto loops = root.find_member("trim_loops"))
        throw loops->complaint("trim_loops are not supported by this version",
                               "an untrimmed surface", "E_SURFACE");
}

std::string text_or(const JsonValue& root, std::string_view key, std::size_t longest,
                    const std::string& otherwise)
{
    const auto value = root.find_member(key);
    return value ? printable(value->text(), longest) : otherwise;
}

// The first of `words` is the default.
std::string_view word_or_first(const JsonValue& root, std::string_view key, Words words)
{
    const auto value = root.find_member(key);
    return value ? value->word(words) : words.front();
}

double mm_per_unit(const JsonValue& root)
{
    constexpr std::array<std::string_view, 2> units{"mm", "inch"};
    return word_or_first(root, "units", units) == "inch" ? mm_per_inch : 1;
}

ToolSide tool_side(const JsonValue& root)
{
    constexpr std::array<std::string_view, 3> sides{"up", "du_cross_dv", "dv_cross_du"};
    const std::string_view side = word_or_first(root, "tool_side", sides);
    if (side == "up")
        return ToolSide::Up;
    return side == "du_cross_dv" ? ToolSide::DuCrossDv : ToolSide::DvCrossDu;
}

// A control point in mm; `unit` is mm per unit of the file.
Vec3 read_point(const JsonValue& value, double unit, const ReadLimits& limits)
{
    if (value.size() != 3)
        throw value.complaint("a point of " + std::to_string(value.size()) + " numbers",
                              "3: x, y, z");
    Vec3 point;
    for (int c = 0; c < 3; ++c) {
        const JsonValue coordinate = value.item(c);
        point[c] = unit * coordinate.number();
        if (std::abs(point[c]) > limits.max_extent_mm || !std::isfinite(point[c]))
            throw coordinate.complaint(
                "coordinate " + coordinate.shown(),
                "at most " + to_text(limits.max_extent_mm) + " mm (--max-extent)",
                "E_RANGE");
    }
    return point;
}

std::string counted(std::size_t count, const char* thing)
{
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

void read_row(const JsonValue& row, double unit, const ReadLimits& limits,
              ControlNet& net)
{
    const auto columns = static_cast<std::size_t>(net.columns());
    if (row.size() != columns)
        throw row.complaint("row has " + counted(row.size(), "point"),
                            std::to_string(columns) + " (3 patches_u + 1)", "E_SURFACE");
    for (std::size_t i = 0; i < columns; ++i)
        net.points.push_back(read_point(row.item(i), unit, limits));
}

ControlNet read_net(const JsonValue& root, double unit, const ReadLimits& limits)
{
    ControlNet net{root.member("patches_u").whole_number(1, most_patches),
                   root.member("patches_v").whole_number(1, most_patches),
                   {}};
    const JsonValue rows = root.member("control_points");
    const auto expected_rows = static_cast<std::size_t>(net.rows());
    if (rows.size() != expected_rows)
        throw rows.complaint("net has " + counted(rows.size(), "row"),
                             std::to_string(expected_rows) + " (3 patches_v + 1)",
                             "E_SURFACE");
    // Memory is taken as points are read, never for what the counts claim.
    for (std::size_t j = 0; j < expected_rows; ++j)
        read_row(rows.item(j), unit, limits, net);
    if (std::ranges::all_of(net.points,
                            [&](const Vec3& p) { return p == net.points.front(); }))
        throw rows.complaint("all control points are equal", "a surface", "E_SURFACE");
    return net;
}

// Whether `count` control points from `first` on, `stride` apart, are one point.
bool is_one_point(const ControlNet& net, std::int64_t first, std::int64_t stride,
                  std::int64_t count)
{
    for (std::int64_t i = 1; i < count; ++i)
        if (net.points[first + i * stride] != net.points[first])
            return false;
    return true;
}

// A border whose control points are one is a pole: sound, but without a normal there.
std::vector<std::string> pole_notes(const ControlNet& net)
{
    const std::int64_t columns = net.columns();
    const std::int64_t rows = net.rows();
    std::vector<std::string> notes;
    const auto note_pole = [&](std::string_view parameter, std::int64_t value) {
        notes.push_back("pole: the border " + std::string{parameter} + " = " +
                        std::to_string(value) + " is a single point, without a normal");
    };
    if (is_one_point(net, 0, columns, rows))
        note_pole("u", 0);
    if (is_one_point(net, columns - 1, columns, rows))
        note_pole("u", net.patches_u);
    if (is_one_point(net, 0, 1, columns))
        note_pole("v", 0);
    if (is_one_point(net, (rows - 1) * columns, 1, columns))
        note_pole("v", net.patches_v);
    return notes;
}

bool counts_up_from_zero(std::span<const double> breaks)
{
    for (std::size_t i = 0; i < breaks.size(); ++i)
        if (breaks[i] != static_cast<double>(i))
            return false;
    return true;
}

// The control point in column i and row j of the composite net, from the patch below it.
Vec3 net_point(const Surface& surface, int i, int j)
{
    const int patch_i = std::min(i / 3, surface.patches(Parameter::U) - 1);
    const int patch_j = std::min(j / 3, surface.patches(Parameter::V) - 1);
    return surface.patch(patch_i, patch_j)
        .control_point(i - 3 * patch_i, j - 3 * patch_j);
}

bool is_bicubic(const Surface& surface)
{
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i) {
            const BezierPatch& patch = surface.patch(i, j);
            if (patch.degree(Parameter::U) != 3 || patch.degree(Parameter::V) != 3 ||
                patch.is_rational())
                return false;
        }
    return true;
}

// Whether the one net that `net_point` reads gives back every patch.
bool shares_borders(const Surface& surface)
{
    for (int patch_j = 0; patch_j < surface.patches(Parameter::V); ++patch_j)
        for (int patch_i = 0; patch_i < surface.patches(Parameter::U); ++patch_i)
            for (int k = 0; k < 16; ++k) {
                const Vec3 own =
                    surface.patch(patch_i, patch_j).control_point(k % 4, k / 4);
                if (own != net_point(surface, 3 * patch_i + k % 4, 3 * patch_j + k / 4))
                    return false;
            }
    return true;
}

void append_point(std::string& text, const Vec3& point)
{
    text += '[';
    append_text(text, point.x());
    text += ", ";
    append_text(text, point.y());
    text += ", ";
    append_text(text, point.z());
    text += ']';
}

std::string net_json(const Surface& surface)
{
    const int columns = 3 * surface.patches(Parameter::U) + 1;
    const int rows = 3 * surface.patches(Parameter::V) + 1;
    std::string text = "[\n";
    for (int j = 0; j < rows; ++j) {
        text += "  [";
        for (int i = 0; i < columns; ++i) {
            text += i == 0 ? "" : ", ";
            append_point(text, net_point(surface, i, j));
        }
        text += j + 1 < rows ? "],\n" : "]\n";
    }
    return text + " ]";
}

std::string_view tool_side_name(ToolSide side)
{
    if (side == ToolSide::Up)
        return "up";
    return side == ToolSide::DuCrossDv ? "du_cross_dv" : "dv_cross_du";
}

}  // namespace

SurfaceFile read_surface(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_surface(read_file(path, limits), path, limits);
}

SurfaceFile parse_surface(std::string_view content, const std::filesystem::path& path,
                          const ReadLimits& limits)
{
    const std::string file = shown_path(path);
    check_content(content, file);
    const JsonDocument document{content, file, limits};
    const JsonValue root = document.root();
    check_format(root);
    check_type(root);
    root.allow_only(bezier_keys);

    const double unit = mm_per_unit(root);
    const ControlNet net = read_net(root, unit, limits);
    std::vector<std::string> notes = pole_notes(net);
    if (unit != 1)
        notes.emplace_back("lengths were converted from inch to mm");
    return {
        text_or(root, "name", longest_name, printable(path.stem().string())),
        text_or(root, "source", longest_source, {}),
        composite_bezier(static_cast<int>(net.patches_u), static_cast<int>(net.patches_v),
                         net.points, tool_side(root)),
        std::move(notes)};
}

std::string surface_json(const SurfaceFile& file)
{
    const Surface& surface = file.surface;
    require(counts_up_from_zero(surface.breaks(Parameter::U)) &&
                counts_up_from_zero(surface.breaks(Parameter::V)),
            "surface_json: the breaks must be 0, 1, 2, …");
    require(is_bicubic(surface), "surface_json: the patches must be bicubic");
    require(shares_borders(surface),
            "surface_json: the patches do not share their borders");

    std::string text = "{\n \"format\": \"endmill-surface/1\",\n";
    text += " \"name\": " + json_string(file.name) + ",\n";
    text += " \"source\": " + json_string(file.source) + ",\n";
    text += " \"type\": \"bezier\",\n";
    text +=
        " \"tool_side\": \"" + std::string{tool_side_name(surface.tool_side())} + "\",\n";
    text += " \"patches_u\": " + std::to_string(surface.patches(Parameter::U)) + ",\n";
    text += " \"patches_v\": " + std::to_string(surface.patches(Parameter::V)) + ",\n";
    text += " \"control_points\": " + net_json(surface) + "\n}\n";
    return text;
}

}  // namespace endmill
