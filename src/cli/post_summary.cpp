// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/post_summary.h"

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/path_facts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

template <class Value>
void add_known(Json& summary, const char* key, const std::optional<Value>& value)
{
    if (value)
        summary[key] = *value;
}

// Adds the number if both ends are equal. Otherwise adds null and the two ends.
void add_range(Json& summary, const std::string& key, const MinMax& range)
{
    if (range.least == range.greatest) {
        summary[key] = range.least ? Json(*range.least) : Json(nullptr);
        return;
    }
    summary[key] = nullptr;
    summary["min_" + key] = *range.least;
    summary["max_" + key] = *range.greatest;
}

std::string feed_text(const Json& s)
{
    if (!s["feed_mm_per_min"].is_null())
        return fmt::format("feed {:g} mm/min", s["feed_mm_per_min"].get<double>());
    if (!s.contains("min_feed_mm_per_min"))
        return "rapids only";
    return fmt::format("feed {:g} to {:g} mm/min", s["min_feed_mm_per_min"].get<double>(),
                       s["max_feed_mm_per_min"].get<double>());
}

}  // namespace

Json post_summary(const PostedPath& posted, const PostOptions& options)
{
    const WrittenProgram& written = posted.written;
    Json summary{{"name", posted.name},
                 {"endmill", program_version},
                 {"format", names_of(options.format).word},
                 {"file", printable(posted.file)},
                 {"units", "mm"},
                 {"programmed_point", "tip"},
                 {"points", posted.read.path.points.size()},
                 {"repeated_points", written.repeated_points},
                 {"slanted_rapids", written.slanted_rapids},
                 {"lines", written.lines},
                 {"bytes", written.text.size()},
                 {"tape_length_m", written.tape_length_m()},
                 {"decimals", options.decimals},
                 {"max_rounding_error_mm", written.max_rounding_error_mm},
                 {"position_error_mm", posted.read.position_error_mm}};
    add_interpreter(summary, options.path);
    add_path_totals(summary, posted.read.path);
    identify_path(summary, posted.read.path.points.size(), written.text);
    add_range(summary, "feed_mm_per_min", written.feed_mm_per_min);
    add_range(summary, "spindle_rpm", written.spindle_rpm);
    if (options.format == PostFormat::Gcode)
        summary["safe_height_mm"] = written.safe_height_mm;
    summary["interpolation"] = "linear";
    summary["cutter"] =
        posted.known.cutter ? Json(cutter_word(*posted.known.cutter)) : Json(nullptr);
    add_known(summary, "chord_tolerance_mm", posted.known.chord_tolerance_mm);
    add_known(summary, "inner_tolerance_mm", posted.known.inner_tolerance_mm);
    add_known(summary, "outer_tolerance_mm", posted.known.outer_tolerance_mm);
    add_known(summary, "scallop_mm", posted.known.scallop_mm);
    summary["remarks"] = posted.read.remarks;
    return summary;
}

std::string post_text(const Json& s)
{
    return fmt::format(
        "{}: {} points in {} lines, {}\n"
        "  rounding      at most {} mm\n",
        s["name"].get<std::string>(), s["points"].get<std::size_t>(),
        s["lines"].get<std::size_t>(), feed_text(s),
        shown_bound(s["max_rounding_error_mm"].get<double>()));
}

}  // namespace endmill
