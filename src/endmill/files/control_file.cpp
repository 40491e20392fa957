// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "endmill/files/detail/json_format.h"
#include "endmill/files/read_file.h"
#include "endmill/post/program.h"

// Texts of a control file become blocks of a program that moves a machine. Every text is
// therefore checked to be words of G-code before it is taken over.

namespace endmill {
namespace {

constexpr std::string_view format_name = "endmill-control/1";
constexpr std::string_view code = "E_CONTROL";
constexpr std::size_t most_blocks = 20;
constexpr std::size_t longest_block = 200;    // characters
constexpr std::size_t longest_extension = 8;  // characters, without the point

constexpr std::array<std::string_view, 26> keys{"format",        "name",
                                                "source",        "extension",
                                                "percent",       "program_number",
                                                "comments",      "capital_comments",
                                                "start",         "end",
                                                "path_control",  "tool_change",
                                                "tool_length",   "first_axes",
                                                "dwell",         "flood",
                                                "mist",          "coolant_off",
                                                "arcs",          "decimals_mm",
                                                "decimals_inch", "speed_decimals",
                                                "always_point",  "line_end",
                                                "longest_line",  "largest_line_number"};

FormatError control_complaint(const JsonValue& value, const std::string& expected)
{
    return value.complaint(value.shown(), expected, std::string{code});
}

bool truth(const JsonValue& root, std::string_view key, bool otherwise)
{
    const auto value = root.find_member(key);
    return value ? value->truth() : otherwise;
}

std::optional<int> whole(const JsonValue& root, std::string_view key, int low, int high)
{
    const auto value = root.find_member(key);
    if (!value)
        return std::nullopt;
    return static_cast<int>(value->whole_number(low, high));
}

// The value whose word stands under `key`. The words and values have the same order.
template <class Value, std::size_t count>
std::optional<Value> choice(const JsonValue& root, std::string_view key,
                            const std::array<std::string_view, count>& words,
                            const std::array<Value, count>& values)
{
    const auto value = root.find_member(key);
    if (!value)
        return std::nullopt;
    const auto found = std::ranges::find(words, value->word(words));
    return values[static_cast<std::size_t>(found - words.begin())];
}

// One M word for the tool change or the coolant, or nothing.
std::optional<std::string> auxiliary_word(const JsonValue& root, std::string_view key)
{
    const auto value = root.find_member(key);
    if (!value)
        return std::nullopt;
    std::string text = value->text();
    if (!is_word(text, 'M'))
        throw control_complaint(*value, "one word such as M6");
    if (!is_auxiliary_word(text))
        throw control_complaint(*value,
                                "an M word that neither stops, ends, calls a program nor "
                                "turns the spindle");
    return text;
}

std::optional<std::string> tool_length_word(const JsonValue& root)
{
    const auto value = root.find_member("tool_length");
    if (!value)
        return std::nullopt;
    std::string text = value->text();
    if (!is_tool_length_word(text))
        throw control_complaint(*value, "\"G43\"");
    return text;
}

// Blocks that are made of words.
std::vector<std::string> blocks(const JsonValue& root, std::string_view key,
                                bool is_start)
{
    const JsonValue list = root.member(key);
    if (list.size() > most_blocks)
        throw control_complaint(list, "at most 20 blocks");
    std::vector<std::string> result;
    for (std::size_t k = 0; k < list.size(); ++k) {
        const JsonValue item = list.item(k);
        std::string text = item.text();
        if (text.size() > longest_block || !is_words(text))
            throw control_complaint(
                item, "words of a capital letter and a number, such as \"G90 G17\"");
        if (const auto unfit = is_start ? unfit_start_word(text) : std::nullopt)
            throw item.complaint(*unfit + " in a block at the start",
                                 *unfit == "G20" || *unfit == "G21"
                                     ? "no unit: --units writes G20 or G21 before it"
                                     : "codes that only set modes, such as G90 or G54",
                                 std::string{code});
        result.push_back(std::move(text));
    }
    return result;
}

std::vector<std::string> end_blocks(const JsonValue& root)
{
    std::vector<std::string> result = blocks(root, "end", false);
    if (std::ranges::none_of(result, ends_program))
        throw root.member("end").complaint(
            "no block with M2 or M30", "one that ends the program", std::string{code});
    return result;
}

// A point, then letters and digits. The summary and the tables of the output folder have
// the extensions .json and .csv.
std::string extension(const JsonValue& root)
{
    const JsonValue value = root.member("extension");
    std::string text = value.text();
    const bool is_fit =
        text.size() >= 2 && text.size() <= 1 + longest_extension && text.front() == '.' &&
        std::all_of(text.begin() + 1, text.end(), [](char letter) {
            return ('a' <= letter && letter <= 'z') || ('0' <= letter && letter <= '9');
        });
    if (!is_fit)
        throw control_complaint(value, "a point and 1 to 8 small letters or digits");
    if (text == ".json" || text == ".csv")
        throw control_complaint(value, "an extension other than .json and .csv");
    return text;
}

// The words and blocks.
void read_words(const JsonValue& root, Control& control)
{
    control.start = blocks(root, "start", true);
    control.end = end_blocks(root);
    control.tool_change = auxiliary_word(root, "tool_change");
    control.tool_length = tool_length_word(root);
    control.flood = auxiliary_word(root, "flood");
    control.mist = auxiliary_word(root, "mist");
    control.coolant_off =
        auxiliary_word(root, "coolant_off").value_or(control.coolant_off);
}

// The forms that a few words name.
void read_forms(const JsonValue& root, Control& control)
{
    using namespace std::string_view_literals;
    control.comments =
        choice(root, "comments", std::array{"parentheses"sv, "semicolon"sv, "none"sv},
               std::array{CommentStyle::Parentheses, CommentStyle::Semicolon,
                          CommentStyle::None})
            .value_or(control.comments);
    control.path_control =
        choice(root, "path_control", std::array{"tolerance"sv, "exact"sv, "none"sv},
               std::array{PathControl::Tolerance, PathControl::Exact, PathControl::None})
            .value_or(PathControl::None);
    control.arcs = choice(root, "arcs", std::array{"centre"sv, "radius"sv, "none"sv},
                          std::array{ArcForm::Centre, ArcForm::Radius, ArcForm::None})
                       .value_or(ArcForm::None);
    control.first_axes = choice(root, "first_axes", std::array{"z"sv, "xy"sv},
                                std::array{FirstAxes::Z, FirstAxes::Xy})
                             .value_or(control.first_axes);
    control.dwell = choice(root, "dwell", std::array{"s"sv, "ms"sv},
                           std::array{DwellUnit::Seconds, DwellUnit::Milliseconds});
    control.crlf =
        choice(root, "line_end", std::array{"lf"sv, "crlf"sv}, std::array{false, true})
            .value_or(control.crlf);
}

// The numbers and answers of yes or no.
void read_numbers(const JsonValue& root, Control& control)
{
    control.percent = truth(root, "percent", control.percent);
    control.capital_comments = truth(root, "capital_comments", control.capital_comments);
    control.always_point = truth(root, "always_point", control.always_point);
    control.program_number = whole(root, "program_number", 1, largest_program_number);
    control.decimals_mm =
        whole(root, "decimals_mm", 0, most_decimals).value_or(control.decimals_mm);
    control.decimals_inch =
        whole(root, "decimals_inch", 0, most_decimals).value_or(control.decimals_inch);
    control.speed_decimals = whole(root, "speed_decimals", 0, most_decimals);
    control.largest_line_number =
        whole(root, "largest_line_number", 1, most_numbered_lines)
            .value_or(control.largest_line_number);
    if (const auto longest =
            whole(root, "longest_line", static_cast<int>(least_longest_line),
                  static_cast<int>(most_longest_line)))
        control.longest_line = static_cast<std::size_t>(*longest);
}

}  // namespace

Control read_control(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_control(read_file(path, limits), path, limits);
}

Control parse_control(std::string_view content, const std::filesystem::path& path,
                      const ReadLimits& limits)
{
    const FormatDocument document{content, path, limits, format_name};
    const JsonValue root = document.root();
    root.allow_only(keys);
    Control control{.name = name_or_stem(root, path),
                    .source = remark(root, "source"),
                    .extension = extension(root)};
    read_words(root, control);
    read_forms(root, control);
    read_numbers(root, control);
    return control;
}

}  // namespace endmill
