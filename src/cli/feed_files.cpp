// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_files.h"

#include <filesystem>

#include <fmt/format.h>

#include "cli/console.h"
#include "endmill/io/feed_csv.h"
#include "endmill/io/feed_svg.h"
#include "endmill/io/printable.h"
#include "endmill/io/tool_path_csv.h"
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
            {fmt::format("{}, {}, {}; mode {}, peak {}", s["material"].get<std::string>(),
                         s["cutter"].get<std::string>(),
                         fmt::format("{} flutes", s["flutes"].get<int>()),
                         s["mode"].get<std::string>(), s["peak"].get<std::string>())}};
}

}  // namespace

Json write_feed(const FeedResult& result, OutputFolder& folder)
{
    const Json summary = feed_summary(result);
    const std::vector<SegmentFeed>& rows = result.plan.rows;
    folder.write("toolpath.csv",
                 tool_path_csv(result.path, limit_words(result.path.points.size(),
                                                        result.cuts.points, rows)));
    folder.write("engagement.csv", feed_csv(result.cuts.cuts, rows));
    folder.write("feed.svg", feed_svg(result.cuts.cuts, rows, figure_of(summary)));
    if (result.input.format != PathFormat::Csv)
        folder.write(program_name(result), program_text(result));
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.remove_unless_written(program_name(result));
    return summary;
}

}  // namespace endmill
