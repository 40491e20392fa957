// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_files.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/figures/feed_svg.h"
#include "endmill/files/path_file.h"
#include "endmill/post/fed_gcode.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {
namespace {

std::string program_name(const FeedResult& result)
{
    return std::filesystem::path{result.options.path.file}.stem().string() + "-feed.ngc";
}

// Passes the program with its feeds to `sink`.
void write_program(const FeedResult& result, const OutputFolder::Sink& sink)
{
    const FeedInput& input = result.input;
    const ToolPath& path = result.cuts.fed.path();
    if (input.format == PathFormat::Gcode)
        return write_fed_gcode(input.text, printable(result.options.path.file),
                               input.reading, path, sink);
    GcodeOptions options;
    options.name = input.name;
    options.cutter = input.tool.cutter;
    options.tolerance = input.known.tolerance_mm();
    sink(gcode(path, options).text);
}

FeedFigure figure_of(const Json& s)
{
    return {"Feed along " + s["name"].get<std::string>(),
            {fmt::format(
                "{}, cutter {} (mm), {}; mode {}, top of the stock at z = {} mm",
                std::filesystem::path{s["material"].get<std::string>()}.stem().string(),
                s["cutter"].get<std::string>(),
                counted(s["flutes"].get<std::size_t>(), "flute"),
                s["mode"].get<std::string>(), shown(s["stock_top_mm"].get<double>()))}};
}

std::optional<double> known(double number)
{
    return std::isnan(number) ? std::nullopt : std::optional{number};
}

// What the chart shows. Slope and depth of a move follow again from its ends.
FeedCurves curves_of(const FeedResult& result)
{
    const FedCuts& cuts = result.cuts;
    const FedPath& fed = cuts.fed;
    const auto tip = [&](std::size_t point) -> const Vec3& {
        return fed.path().points[point].location.tip;
    };
    const auto slope = [&cuts, tip, top = result.input.stock_top](std::size_t i) {
        return move_slope(tip(cuts.points[i] - 1), tip(cuts.points[i]), top);
    };
    const auto conditions = [&](std::size_t i) -> const CuttingConditions& {
        return fed.path().points[cuts.points[i]].conditions;
    };
    return {
        .count = cuts.points.size(),
        .length_mm =
            [&cuts, tip](std::size_t i) {
                return (tip(cuts.points[i]) - tip(cuts.points[i] - 1)).norm();
            },
        .mu = [&](std::size_t i) { return known(cuts.mu[i]); },
        .lambda = [slope](std::size_t i) { return slope(i).lambda; },
        .pick_feed_mm = [&](std::size_t i) { return known(cuts.pick_feed_mm[i]); },
        .pick_feed_horizontal_mm =
            [&](std::size_t i) { return known(cuts.horizontal_mm[i]); },
        .depth_mm = [slope](std::size_t i) { return slope(i).depth_mm; },
        .feed_mm_per_min =
            [conditions](std::size_t i) { return conditions(i).feed_mm_per_min; },
        .spindle_rpm = [conditions](std::size_t i) { return conditions(i).spindle_rpm; },
        .limit = [&](std::size_t i) { return fed.limit(cuts.points[i]); },
        .speed_limit = [&](std::size_t i) { return fed.speed_limit(cuts.points[i]); }};
}

using Produce = std::function<void(const OutputFolder::Sink&)>;

// Writes a file in pieces. Returns the SHA-256 of its content.
std::string write_identified(OutputFolder& folder, const std::string& name,
                             const Produce& produce)
{
    ContentSha256 sum;
    folder.write_pieces(name, [&](const OutputFolder::Sink& sink) {
        produce([&](std::string_view piece) {
            sum.add(piece);
            sink(piece);
        });
    });
    return sum.word();
}

}  // namespace

Json write_feed(const FeedResult& result, OutputFolder& folder)
{
    Json summary = feed_summary(result);
    const FedPath& fed = result.cuts.fed;
    const bool has_program = result.input.format != PathFormat::Csv;
    std::string path_sum;
    std::string program_sum;
    // The files are made in parallel, since the program and the figure each take one thread
    // for long.
    const std::array<std::function<void()>, 3> works{
        [&] {
            path_sum = write_identified(folder, "toolpath.csv", [&](const auto& sink) {
                write_tool_path_csv(
                    fed.path(), [&](std::size_t i) { return fed.limit_word(i); }, sink);
            });
        },
        [&] {
            if (has_program)
                program_sum = write_identified(
                    folder, program_name(result),
                    [&](const auto& sink) { write_program(result, sink); });
        },
        [&] {
            folder.write("feed.svg", feed_svg(curves_of(result), figure_of(summary)));
        }};
    parallel_for(works.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            works[i]();
    });
    identify_path(summary, fed.path().points.size(), path_sum);
    add_source_path(summary, result.options.path.file, result.options.common.limits);
    if (has_program)
        summary["program_sha256"] = program_sum;
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.remove_unless_written(program_name(result));
    return summary;
}

}  // namespace endmill
