// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/surface_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/files/detail/json_format.h"
#include "endmill/files/detail/strict_json.h"
#include "endmill/files/detail/surface_kinds.h"
#include "endmill/files/read_file.h"
#include "endmill/surface/detail/collapsed_edge.h"

// A surface file is read in these steps:
//
// 1. The format and its version are checked before all other keys (json_format.h).
// 2. The type selects a Kind, which has the allowed keys and the reader
//    (surface_kinds.h).
// 3. The reader builds the surfaces; rules of the library that it does not check are
//    reported as errors in the file.
// 4. Poles are found: borders that are a single point, and corners without a normal. Such
//    surfaces are valid, but a tool cannot be placed there, so a note states each pole.

namespace endmill {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view format_name = "endmill-surface/1";
constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_source = 2000;

using KindReader = std::vector<Surface> (*)(const SurfaceSource&);

// A type of surface: its word in files, its keys beside `common_keys`, and its reader.
struct Kind {
    std::string_view word;
    std::vector<std::string_view> keys;
    KindReader read;
};

// All types of surfaces. A new type is one more entry.
const std::array<Kind, 4>& kinds()
{
    static const std::array<Kind, 4> all{
        {{"bezier", {"patches_u", "patches_v", "control_points"}, read_bezier},
         {"nurbs",
          {"degree_u", "degree_v", "knots_u", "knots_v", "control_points", "weights"},
          read_nurbs},
         {"bezier-patches", {"patches"}, read_bezier_patches},
         {"height-grid", {"x", "y", "z"}, read_height_grid}}};
    return all;
}

// Reads the surfaces. A rule of the library that the reader does not check itself is
// reported as an error in the file.
std::vector<Surface> read_kind(const Kind& kind, const SurfaceSource& source)
{
    try {
        return kind.read(source);
    } catch (const DomainError& error) {
        throw source.root.complaint(error.what(), "a valid surface", "E_SURFACE");
    }
}

// The type of the file, after a check that it has no keys of another type.
const Kind& kind_of(const JsonValue& root)
{
    constexpr std::array<std::string_view, 7> common_keys{
        "format", "name", "source", "type", "units", "tool_side", "trim_loops"};
    std::vector<std::string_view> words;
    for (const Kind& kind : kinds())
        words.push_back(kind.word);
    const JsonValue value = root.member("type");
    const std::string_view word = value.word(words);
    if (const auto loops = root.find_member("trim_loops"))
        throw loops->complaint("trim_loops are not supported by this version",
                               "an untrimmed surface", "E_SURFACE");
    const Kind& kind = *std::ranges::find(kinds(), word, &Kind::word);
    std::vector<std::string_view> keys{common_keys.begin(), common_keys.end()};
    keys.insert(keys.end(), kind.keys.begin(), kind.keys.end());
    root.allow_only(keys);
    return kind;
}

// The text of a key, made printable and shortened, or `otherwise`.
std::string text_or(const JsonValue& root, std::string_view key, std::size_t longest,
                    const std::string& otherwise)
{
    const auto value = root.find_member(key);
    return value ? printable(value->text(), longest) : otherwise;
}

// The word under `key`; the first of `words` if the key is missing.
std::string_view word_or_first(const JsonValue& root, std::string_view key, Words words)
{
    const auto value = root.find_member(key);
    return value ? value->word(words) : words.front();
}

// Conversion factor of the length unit of the file; the default is mm.
double mm_per_unit(const JsonValue& root)
{
    constexpr std::array<std::string_view, 2> units{"mm", "inch"};
    return word_or_first(root, "units", units) == "inch" ? mm_per_inch : 1;
}

// The side of the surface on which the tool is; the default is above.
ToolSide tool_side(const JsonValue& root)
{
    constexpr std::array<std::string_view, 3> sides{"up", "du_cross_dv", "dv_cross_du"};
    const std::string_view side = word_or_first(root, "tool_side", sides);
    if (side == "up")
        return ToolSide::Up;
    return side == "du_cross_dv" ? ToolSide::DuCrossDv : ToolSide::DvCrossDu;
}

// Whether the border at one end of the range of `along` is a single point: the border of
// every patch is collapsed, and all of them to the same point.
bool is_pole(const Surface& surface, Parameter along, int end)
{
    const Parameter other = along == Parameter::U ? Parameter::V : Parameter::U;
    const int last = end == 0 ? 0 : surface.patches(along) - 1;
    std::optional<Vec3> pole;
    for (int k = 0; k < surface.patches(other); ++k) {
        const BezierPatch& patch =
            along == Parameter::U ? surface.patch(last, k) : surface.patch(k, last);
        const Vec3 corner =
            along == Parameter::U
                ? patch.control_point(end * patch.degree(Parameter::U), 0)
                : patch.control_point(0, end * patch.degree(Parameter::V));
        if (!is_collapsed(patch, along, end) ||
            (pole && (*pole - corner).norm() > same_point_share * surface.diagonal()))
            return false;
        pole = corner;
    }
    return true;
}

// The note about a border that is a single point. Such a surface is valid but has no
// normal there.
std::string pole_note(const Surface& surface, Parameter along, int end,
                      const std::string& of_patch)
{
    const Interval range = surface.range(along);
    return "pole: the border " + std::string{along == Parameter::U ? "u" : "v"} + " = " +
           to_text(end == 0 ? range.low : range.high) + of_patch +
           " is a single point, without a normal";
}

// Notes about corners without a normal: the partials are parallel or one of them is zero,
// although both borders at the corner have a length.
std::vector<std::string> corner_notes(const Surface& surface, const std::string& of_patch)
{
    std::vector<std::string> notes;
    for (const int end_u : {0, 1})
        for (const int end_v : {0, 1}) {
            if (is_pole(surface, Parameter::U, end_u) ||
                is_pole(surface, Parameter::V, end_v))
                continue;
            const Interval u = surface.range(Parameter::U);
            const Interval v = surface.range(Parameter::V);
            const SurfacePoint at{end_u == 0 ? u.low : u.high,
                                  end_v == 0 ? v.low : v.high};
            if (is_singular(surface.tangents(at.u, at.v)))
                notes.push_back("pole: the corner u = " + to_text(at.u) +
                                ", v = " + to_text(at.v) + of_patch + " has no normal");
        }
    return notes;
}

// Notes about all poles. With several surfaces each note names its patch.
std::vector<std::string> pole_notes(std::span<const Surface> surfaces)
{
    std::vector<std::string> notes;
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        const std::string of_patch =
            surfaces.size() > 1 ? " of patch " + std::to_string(number) : "";
        for (const Parameter along : {Parameter::U, Parameter::V})
            for (const int end : {0, 1})
                if (is_pole(surfaces[number], along, end))
                    notes.push_back(pole_note(surfaces[number], along, end, of_patch));
        for (std::string& note : corner_notes(surfaces[number], of_patch))
            notes.push_back(std::move(note));
    }
    return notes;
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
    const FormatDocument document{content, path, limits, format_name};
    const JsonValue root = document.root();
    const Kind& kind = kind_of(root);

    const double unit = mm_per_unit(root);
    std::vector<Surface> surfaces = read_kind(
        kind, {root, {unit, limits.max_extent_mm}, tool_side(root), file, limits});
    std::vector<std::string> notes = pole_notes(surfaces);
    if (unit != 1)
        notes.emplace_back("lengths were converted from inch to mm");
    return {text_or(root, "name", longest_name, printable(path.stem().string())),
            text_or(root, "source", longest_source, {}), std::move(surfaces),
            std::move(notes)};
}

namespace {

// A text as a JSON string.
std::string quoted(const std::string& text, std::size_t longest)
{
    std::string result = "\"";
    for (const char letter : printable(text, longest)) {
        if (letter == '"' || letter == '\\')
            result += '\\';
        result += letter;
    }
    return result + '"';
}

// Numbers as a JSON array.
std::string array_text(std::span<const double> numbers)
{
    std::string text = "[";
    for (const double number : numbers) {
        text += text.size() == 1 ? "" : ", ";
        append_text(text, number);
    }
    return text + ']';
}

// Rows of `columns` items each as a JSON array of arrays.
template <typename Item, typename Text>
std::string rows_text(std::span<const Item> items, std::size_t columns, Text item_text)
{
    std::string text = "[";
    for (std::size_t i = 0; i < items.size(); ++i) {
        const bool is_first = i % columns == 0;
        text += is_first ? (i == 0 ? "\n  [" : ",\n  [") : ", ";
        text += item_text(items[i]);
        text += (i + 1) % columns == 0 ? "]" : "";
    }
    return text + ']';
}

}  // namespace

std::string surface_text(const Nurbs& nurbs, ToolSide tool_side, const std::string& name,
                         const std::string& source)
{
    const auto columns = static_cast<std::size_t>(nurbs.u.points());
    std::string text =
        "{\"format\": \"endmill-surface/1\", \"name\": " + quoted(name, longest_name) +
        ", \"source\": " + quoted(source, longest_source) + ", \"type\": \"nurbs\",\n";
    if (tool_side != ToolSide::Up)
        text += " \"tool_side\": \"" +
                std::string{tool_side == ToolSide::DuCrossDv ? "du_cross_dv"
                                                             : "dv_cross_du"} +
                "\",\n";
    text += " \"degree_u\": " + std::to_string(nurbs.u.degree) +
            ", \"degree_v\": " + std::to_string(nurbs.v.degree) +
            ",\n \"knots_u\": " + array_text(nurbs.u.knots) +
            ",\n \"knots_v\": " + array_text(nurbs.v.knots) + ",\n \"control_points\": " +
            rows_text(std::span{nurbs.control_points}, columns, [](const Vec3& point) {
                return array_text({point.data(), 3});
            });
    if (!nurbs.weights.empty())
        text += ",\n \"weights\": " +
                rows_text(std::span{nurbs.weights}, columns,
                          [](double weight) { return to_text(weight); });
    return text + "}\n";
}

}  // namespace endmill
