// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/info_path.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/answer.h"
#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/path_tools.h"
#include "cli/shown_numbers.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::array<std::string_view, 5> part_extensions{".json", ".stl", ".obj", ".ply",
                                                          ".off"};

// The extension of a file, in lower case.
std::string extension_of(const std::string& file)
{
    std::string extension = std::filesystem::path{file}.extension().string();
    for (char& letter : extension)
        if ('A' <= letter && letter <= 'Z')
            letter = static_cast<char>(letter - 'A' + 'a');
    return extension;
}

std::string format_word(PathFormat format)
{
    switch (format) {
        case PathFormat::Csv:
            return "tool path (CSV)";
        case PathFormat::Gcode:
            return "G-code";
        case PathFormat::Canonical:
            return "output of rs274 -g";
        case PathFormat::Apt:
            return "APT CL data";
    }
    return {};
}

// Adds the least and the greatest of a setting; null if no move has it.
void add_range(Json& summary, const std::string& key, const MinMax& range)
{
    summary["min_" + key] = range.least ? Json(*range.least) : Json(nullptr);
    summary["max_" + key] = range.greatest ? Json(*range.greatest) : Json(nullptr);
}

void add_conditions(Json& summary, const ToolPath& path)
{
    MinMax feeds;
    MinMax speeds;
    for (const PathPoint& point : path.points) {
        if (point.conditions.feed_mm_per_min)
            feeds.add(*point.conditions.feed_mm_per_min);
        if (point.conditions.spindle_rpm)
            speeds.add(*point.conditions.spindle_rpm);
    }
    add_range(summary, "feed_mm_per_min", feeds);
    add_range(summary, "spindle_rpm", speeds);
}

// What is known of a path beside its moves.
struct PathData {
    PathFormat format;
    std::optional<std::string> name;
    std::optional<Cutter> cutter;  // of all moves
    std::vector<NumberedTool> tools;
};

Json path_summary(const PathOptions& options, const Program& program,
                  const PathData& known)
{
    const std::string stem = std::filesystem::path{options.file}.stem().string();
    const auto& cutter = known.cutter;
    Json summary{{"name", printable(known.name.value_or(stem))},
                 {"endmill", program_version},
                 {"toolpath", printable(options.file)},
                 {"format", format_word(known.format)},
                 {"points", program.path.points.size()},
                 {"cutter", cutter ? Json(cutter_word(*cutter)) : Json(nullptr)}};
    summary["cutters"] = cutters_json(known.tools);
    add_path_totals(summary, path_totals(program.path));
    add_conditions(summary, program.path);
    add_reading(summary, options);
    summary["position_error_mm"] = program.position_error_mm;
    summary["remarks"] = program.remarks;
    return summary;
}

// "100 to 800", "800", or "not known".
std::string range_text(const Json& s, const std::string& key, const std::string& unit)
{
    const Json& least = s["min_" + key];
    const Json& greatest = s["max_" + key];
    if (least.is_null())
        return "not known";
    const std::string low = shown(least.get<double>());
    const std::string high = shown(greatest.get<double>());
    return (low == high ? low : low + " to " + high) + unit;
}

// "1, 2", or with a tool table "1 flat:10, 2 ball:6".
std::string tools_text(const Json& s)
{
    std::string text;
    if (s["cutters"].is_null())
        for (const Json& tool : s["tools"])
            text += (text.empty() ? "" : ", ") + std::to_string(tool.get<int>());
    else
        for (const Json& tool : s["cutters"])
            text +=
                fmt::format("{}{} {}", text.empty() ? "" : ", ", tool["tool"].get<int>(),
                            tool["cutter"].get<std::string>());
    return text.empty() ? "not named" : text;
}

std::string path_text(const Json& s)
{
    return fmt::format(
        "{}: {}, {}\n"
        "{}"
        "  extent      {}\n"
        "  settings    feed {}; spindle {}; tools {}\n",
        s["name"].get<std::string>(), s["format"].get<std::string>(),
        counted(s["points"].get<std::size_t>(), "point"), path_totals_text(s),
        extent_text(s), range_text(s, "feed_mm_per_min", " mm/min"),
        range_text(s, "spindle_rpm", " rpm"), tools_text(s));
}

}  // namespace

bool is_tool_path(const std::string& file, const ReadLimits& limits)
{
    if (std::ranges::find(part_extensions, extension_of(file)) != part_extensions.end())
        return false;
    if (has_path_extension(file))
        return true;  // its reader reports what is wrong
    try {
        path_format(read_file(file, limits), file);
    } catch (const FormatError&) {
        return false;
    }
    return true;
}

ExitCode report_path(const PathOptions& path, const CommonOptions& options)
{
    // A report on a path judges nothing, so a summary of another path needs no warning.
    CommonOptions silent = options;
    silent.quiet = true;
    refuse_idle_tool_options(path, options);
    const std::vector<NumberedTool> table = read_tools_for(path, options);
    const PathSummary beside = path_summary_of(path, silent);
    std::optional<Cutter> cutter = path.cutter ? path.cutter : beside.cutter;
    if (!table.empty())
        cutter =
            table.size() == 1 ? std::optional{table.front().tool.cutter} : std::nullopt;
    const Program program = read_program_for(path, cutter, options, beside.machine);
    for (const std::string& remark : program.remarks)
        warn(options, path.file + ": " + remark);
    PathData known{.format = path_format(read_file(path.file, options.limits), path.file),
                   .name = beside.name,
                   .cutter = program.cutter ? program.cutter : beside.cutter,
                   .tools = {}};
    std::vector<std::string> files{path.file};
    if (!table.empty()) {
        PathTools used = tools_of_path(program.path, printable(path.file),
                                       printable(path.tools), table);
        known.cutter = only_cutter(used);
        known.tools = std::move(used.used);
        files.push_back(path.tools);
    }
    const Json summary = path_summary(path, program, known);
    give_answer(options, files, summary, path_text(summary));
    return ExitCode::Yes;
}

}  // namespace endmill
