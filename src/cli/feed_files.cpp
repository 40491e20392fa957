// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_files.h"

#include <array>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/figures/feed_svg.h"
#include "endmill/files/path_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/post/fed_gcode.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/process/fed_path.h"

namespace endmill {
namespace {

std::string program_name(const FeedResult& result)
{
    return std::filesystem::path{result.options.path.file}.stem().string() + "-feed.ngc";
}

std::string program_text(const FeedResult& result)
{
    const FeedInput& input = result.input;
    if (input.format == PathFormat::Gcode)
        return fed_gcode(input.text, printable(result.options.path.file), input.reading,
                         result.path);
    GcodeOptions options;
    options.name = input.name;
    options.cutter = input.tool.cutter;
    options.tolerance = input.known.tolerance_mm();
    return gcode(result.path, options).text;
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

// The contents of two output files.
struct FeedTexts {
    std::string figure;
    std::string program;  // only if the input is a machine program
};

// Creates the texts in parallel. Each one takes long and is sequential in itself.
FeedTexts texts_of(const FeedResult& result, const Json& summary)
{
    FeedTexts texts;
    const std::array<std::function<void()>, 2> works{
        [&] {
            texts.figure =
                feed_svg(result.cuts.cuts, result.plan.rows, figure_of(summary));
        },
        [&] {
            if (result.input.format != PathFormat::Csv)
                texts.program = program_text(result);
        }};
    parallel_for(works.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            works[i]();
    });
    return texts;
}

// Writes the path and adds its length and content to the summary. Its text is released
// before the others are made.
void write_path(const FeedResult& result, OutputFolder& folder, Json& summary)
{
    const std::size_t points = result.path.points.size();
    const std::string text = tool_path_csv(
        result.path, limit_words(points, result.cuts.points, result.plan.rows));
    identify_path(summary, points, text);
    folder.write("toolpath.csv", text);
}

}  // namespace

Json write_feed(const FeedResult& result, OutputFolder& folder)
{
    Json summary = feed_summary(result);
    write_path(result, folder, summary);
    folder.write_pieces("engagement.csv", [&](const OutputFolder::Sink& sink) {
        write_feed_csv(result.cuts.cuts, result.plan.rows, sink);
    });
    const FeedTexts texts = texts_of(result, summary);
    if (!texts.program.empty())
        summary["program_sha256"] = content_sha256(texts.program);
    folder.write("feed.svg", texts.figure);
    if (result.input.format != PathFormat::Csv)
        folder.write(program_name(result), texts.program);
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.remove_unless_written(program_name(result));
    return summary;
}

}  // namespace endmill
