// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/path_tools.h"

#include <algorithm>
#include <set>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Consecutive moves of one tool.
struct ToolSpan {
    std::size_t first;          // number of the first point
    std::optional<int> number;  // of the tool, if the path names it
    bool is_at_feed = false;    // whether a move is not a rapid
};

// Refuses cuts before the first named tool: no tool is known for them.
void require_known_tools(const ToolPath& path, const std::string& file)
{
    std::optional<std::size_t> cut;  // the first point reached at feed without a tool
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const std::optional<int>& tool = path.points[k].conditions.tool;
        if (tool && cut)
            throw DomainError{file + ": the move to point " + std::to_string(*cut) +
                              " cuts before the first tool T" + std::to_string(*tool) +
                              " at point " + std::to_string(k) +
                              "; expected a tool before the first cut"};
        if (tool)
            return;
        if (k > 0 && !cut && path.points[k].move != Move::Rapid)
            cut = k;
    }
}

// The spans as the path states them. Rapids before the first named tool are those of this
// tool, moves without a number those of the tool before.
std::vector<ToolSpan> stated_spans(const ToolPath& path)
{
    std::vector<ToolSpan> spans;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const std::optional<int>& tool = path.points[k].conditions.tool;
        const bool is_change =
            k > 0 && tool && spans.back().number && tool != spans.back().number;
        if (k == 0 || is_change)
            spans.push_back({k, tool});
        if (tool)
            spans.back().number = tool;
        if (path.points[k].move != Move::Rapid)
            spans.back().is_at_feed = true;
    }
    return spans;
}

// The spans in which a tool cuts. Rapids of a tool that never cuts belong to the next span,
// those at the end to the last one.
std::vector<ToolSpan> cutting_spans(const ToolPath& path)
{
    std::vector<ToolSpan> spans;
    std::optional<std::size_t> first;  // of the rapids before the next span
    for (ToolSpan span : stated_spans(path)) {
        if (!span.is_at_feed) {
            first = first.value_or(span.first);
            continue;
        }
        span.first = first.value_or(span.first);
        first.reset();
        if (spans.empty() || spans.back().number != span.number)
            spans.push_back(span);
    }
    if (spans.empty())
        spans.push_back({0, path.points.empty() ? std::nullopt
                                                : path.points.front().conditions.tool});
    spans.front().first = 0;
    return spans;
}

const NumberedTool& row_of(const ToolSpan& span, const std::string& file,
                           const std::string& table_file,
                           const std::vector<NumberedTool>& table)
{
    if (!span.number && table.size() == 1)
        return table.front();
    if (!span.number)
        throw DomainError{file + ": the path names no tool, and " + table_file + " has " +
                          counted(table.size(), "tool") +
                          "; expected --cutter instead of --tools"};
    const auto found = std::ranges::find(table, *span.number, &NumberedTool::number);
    if (found == table.end())
        throw FormatError{"E_TOOLS",
                          {table_file, "",
                           "no row with a cutter for tool " +
                               std::to_string(*span.number) + ", which " + file + " uses",
                           "a row for each tool of the path, in a .tbl with a diameter D "
                           "above 0"}};
    return *found;
}

}  // namespace

PathTools tools_of_path(const ToolPath& path, const std::string& file,
                        const std::string& table_file,
                        const std::vector<NumberedTool>& table)
{
    require_known_tools(path, file);
    const std::vector<ToolSpan> spans = cutting_spans(path);
    PathTools tools{row_of(spans.front(), file, table_file, table).tool, {}};
    std::set<int> used;
    for (const ToolSpan& span : spans) {
        const NumberedTool& row = row_of(span, file, table_file, table);
        if (span.first > 0)
            tools.changes.push_back({span.first, row.tool.cutter, tool_body(row.tool),
                                     row.tool.cutting_length});
        used.insert(row.number);
    }
    for (const NumberedTool& row : table)
        if (used.contains(row.number))
            tools.used.push_back(row);
    return tools;
}

void put_rapids_of_no_tool_to_others(ToolPath& path)
{
    const auto has_no_tool = [](const PathPoint& point) {
        return point.conditions.tool == 0;
    };
    for (const PathPoint& point : path.points)
        if (has_no_tool(point) && point.move != Move::Rapid)
            return;
    const auto first = std::ranges::find_if_not(path.points, has_no_tool);
    if (first == path.points.end())
        return;
    std::optional<int> tool = first->conditions.tool;
    for (PathPoint& point : path.points) {
        if (has_no_tool(point))
            point.conditions.tool = tool;
        tool = point.conditions.tool;
    }
}

Json cutters_json(const std::vector<NumberedTool>& tools)
{
    Json list = nullptr;
    for (const auto& [number, tool] : tools)
        list.push_back({{"tool", number}, {"cutter", cutter_word(tool.cutter)}});
    return list;
}

std::optional<Cutter> only_cutter(const PathTools& tools)
{
    const Cutter& first = tools.first.cutter;
    const bool is_only = std::ranges::all_of(
        tools.changes, [&](const ToolChange& change) { return change.cutter == first; });
    return is_only ? std::optional{first} : std::nullopt;
}

void refuse_several_tools(const ToolPath& path, const std::string& file)
{
    require_known_tools(path, file);
    constexpr std::size_t most_named = 10;
    std::set<int> numbers;
    for (const ToolSpan& span : cutting_spans(path))
        if (span.number)
            numbers.insert(*span.number);
    if (numbers.size() < 2)
        return;
    std::string text;
    std::size_t named = 0;
    for (const int number : numbers)
        if (named++ < most_named)
            text += (named > 1 ? ", T" : "T") + std::to_string(number);
    throw DomainError{file + ": several tools cut (" + text +
                      (named > most_named ? ", ..." : "") +
                      "); expected --tools FILE, a table with the cutter of each"};
}

}  // namespace endmill
