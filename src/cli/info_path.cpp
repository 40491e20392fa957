// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/info_path.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/answer.h"
#include "cli/console.h"
#include "cli/path_facts.h"
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

Json path_summary(const PathOptions& options, PathFormat format, const Program& program,
                  const PathSummary& known)
{
    const std::string stem = std::filesystem::path{options.file}.stem().string();
    const auto& cutter = program.cutter ? program.cutter : known.cutter;
    Json summary{{"name", printable(known.name.value_or(stem))},
                 {"endmill", program_version},
                 {"toolpath", printable(options.file)},
                 {"format", format_word(format)},
                 {"points", program.path.points.size()},
                 {"cutter", cutter ? Json(cutter_word(*cutter)) : Json(nullptr)}};
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

std::string tools_text(const Json& tools)
{
    std::string text;
    for (const Json& tool : tools)
        text += (text.empty() ? "" : ", ") + std::to_string(tool.get<int>());
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
        range_text(s, "spindle_rpm", " rpm"), tools_text(s["tools"]));
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
    const PathSummary known = path_summary_of(path, silent);
    const Program program =
        read_program_for(path, path.cutter ? path.cutter : known.cutter, options);
    for (const std::string& remark : program.remarks)
        warn(options, path.file + ": " + remark);
    const PathFormat format =
        path_format(read_file(path.file, options.limits), path.file);
    const Json summary = path_summary(path, format, program, known);
    give_answer(options, {path.file}, summary, path_text(summary));
    return ExitCode::Yes;
}

}  // namespace endmill
