// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "endmill/core/error.h"
#include "endmill/files/detail/json_format.h"
#include "endmill/files/detail/tool_rows.h"
#include "endmill/files/detail/tool_value.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::string_view table_format = "endmill-tools/1";

// Bytes of a tool with shank and holder in memory, for each byte of its text.
constexpr double bytes_a_byte = 8;

// A tool with the place of its row in the file.
struct PlacedTool {
    NumberedTool row;
    std::string place;
};

// The tool under the key `tool`: a cutter word, or an object.
Tool table_tool(const JsonValue& value, const ReadLimits& limits)
{
    if (!value.is_text()) {
        if (const auto format = value.find_member("format"))
            format->word(std::array{tool_format});
        return tool_in(value, limits);
    }
    if (const auto cutter = cutter_from_word(value.text()))
        return Tool{.cutter = *cutter};
    throw value.complaint(value.shown(), expected_cutter(value.text()));
}

std::vector<PlacedTool> rows_of_json(std::string_view content,
                                     const std::filesystem::path& path,
                                     const ReadLimits& limits)
{
    constexpr std::array<std::string_view, 4> keys{"format", "name", "source", "tools"};
    constexpr std::array<std::string_view, 2> row_keys{"number", "tool"};
    const FormatDocument document{content, path, limits, table_format};
    const JsonValue root = document.root();
    root.allow_only(keys);
    remark(root, "name");  // not stored; this checks that both are texts
    remark(root, "source");
    const JsonValue list = root.member("tools");
    std::vector<PlacedTool> rows;
    for (std::size_t k = 0; k < list.size(); ++k) {
        const JsonValue row = list.item(k);
        row.allow_only(row_keys);
        const JsonValue number = row.member("number");
        const JsonValue tool = row.member("tool");
        rows.push_back(
            {{static_cast<int>(number.whole_number(0, std::numeric_limits<int>::max())),
              table_tool(tool, limits)},
             number.pointer()});
    }
    return rows;
}

std::vector<PlacedTool> rows_of_text(std::string_view content, const std::string& file,
                                     const ToolTableOptions& options)
{
    std::vector<PlacedTool> rows;
    for (ToolRow& row :
         tool_rows(content, file, options.unit_mm, options.limits.max_extent_mm))
        rows.push_back(
            {{row.number, Tool{.cutter = row.cutter, .name = std::move(row.name)}},
             std::to_string(row.line)});
    return rows;
}

// Whether the content is JSON and not a table of LinuxCNC.
bool is_json(std::string_view content)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (content.starts_with(byte_order_mark))
        content.remove_prefix(byte_order_mark.size());
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos &&
           (content[first] == '{' || content[first] == '[');
}

}  // namespace

std::vector<NumberedTool> read_tool_table(const std::filesystem::path& path,
                                          const ToolTableOptions& options)
{
    return parse_tool_table(read_file(path, options.limits), path, options);
}

std::vector<NumberedTool> parse_tool_table(std::string_view content,
                                           const std::filesystem::path& path,
                                           const ToolTableOptions& options)
{
    const std::string file = shown_path(path);
    require_memory(file, bytes_a_byte * static_cast<double>(content.size()),
                   options.limits);
    if (is_json(content) && options.unit_mm)
        throw DomainError{"--tools-units: has no effect with " + file +
                          ", whose lengths are in mm; expected a tool table of LinuxCNC"};
    std::vector<PlacedTool> rows = is_json(content)
                                       ? rows_of_json(content, path, options.limits)
                                       : rows_of_text(content, file, options);
    if (rows.empty())
        throw FormatError{
            "E_TOOLS",
            {file, "", is_json(content) ? "no tool" : "no row with a diameter",
             is_json(content) ? "at least one tool" : "rows such as T1 P1 D6.0"}};
    std::ranges::stable_sort(rows, {},
                             [](const PlacedTool& tool) { return tool.row.number; });
    const auto twice = std::ranges::adjacent_find(
        rows, {}, [](const PlacedTool& tool) { return tool.row.number; });
    if (twice != rows.end())
        throw FormatError{"E_TOOLS",
                          {file, (twice + 1)->place,
                           "tool " + std::to_string(twice->row.number) + " a second time",
                           "each number once"}};
    std::vector<NumberedTool> tools;
    tools.reserve(rows.size());
    for (PlacedTool& row : rows)
        tools.push_back(std::move(row.row));
    return tools;
}

}  // namespace endmill
