// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/post_summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/path_facts.h"
#include "cli/path_tools.h"
#include "cli/shown_numbers.h"
#include "endmill/core/angle.h"
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

// The one number under `key`, or its range; empty if it is unknown.
std::string range_text(const Json& s, const std::string& key)
{
    if (!s[key].is_null())
        return shown(s[key].get<double>());
    if (!s.contains("min_" + key))
        return "";
    return shown(s["min_" + key].get<double>()) + " to " +
           shown(s["max_" + key].get<double>());
}

// Feeds and spindle speed.
std::string conditions_text(const Json& s)
{
    const std::string cutting = range_text(s, "feed_mm_per_min");
    const std::string plunge = range_text(s, "plunge_feed_mm_per_min");
    const std::string speed = range_text(s, "spindle_rpm");
    std::string text = cutting.empty() ? "" : "cut " + cutting;
    if (!plunge.empty())
        text += (text.empty() ? "" : ", ") + ("plunge " + plunge);
    text += text.empty() ? "rapids only" : " mm/min";
    return text + (speed.empty() ? "; spindle speed not known" : "; " + speed + " rpm");
}

// A line about descents that take more than half of the time or are longer than the cuts;
// empty if an option made them rapid, or if there are none.
std::string descents_text(const PostedPath& posted, const PostOptions& options)
{
    const PathTotals& totals = posted.written.totals;
    constexpr double large_share = 0.5;
    const bool is_slow =
        totals.plunge_mm > totals.cut_mm ||
        totals.plunge_time_min > large_share * totals.time_min.value_or(HUGE_VAL);
    if (!posted.control || options.approach_distance || !is_slow || posted.motion)
        return "";
    return fmt::format(
        "  descents    {} of {} min; --approach-distance MM makes them "
        "rapid down to MM above the cut\n",
        shown_time(totals.plunge_time_min),
        shown_time(totals.time_min.value_or(totals.plunge_time_min)));
}

// Adds the keys that only G-code has.
void add_gcode_keys(Json& summary, const PostedPath& posted, const PostOptions& options)
{
    const WrittenProgram& written = posted.written;
    summary["safe_height_mm"] = written.safe_height_mm;
    summary["control"] = posted.control->name;
    summary["program_unit"] = options.unit == ProgramUnit::Inch ? "inch" : "mm";
    summary["coolant"] = word_of(options.coolant);
    summary["approach_distance_mm"] =
        options.approach_distance ? Json(*options.approach_distance) : Json(nullptr);
    summary["ramps"] = written.ramps;
    summary["straight_descents"] = written.straight_descents;
    summary["arcs"] = written.arcs;
    summary["max_arc_error_mm"] = written.max_arc_error_mm;
}

double degrees_of(double radians)
{
    return Angle::radians(radians).written_degrees();
}

// Adds the keys of a program with rotary axes.
void add_motion_keys(Json& summary, const PostedMotion& motion,
                     const PostOptions& options)
{
    const MachinePathReport& report = motion.report;
    const bool is_joint = motion.machine.interpolation == Interpolation::Joint;
    summary["frame"] = is_joint ? "joint" : "part";
    summary["programmed_point"] = is_joint ? "axes" : "tip";
    summary["tolerance_mm"] = motion.tolerance_mm;
    summary["singular"] = word_of(options.machine.singular);
    summary["time_min"] = report.time_min;
    summary["rotary_travel_deg"] = degrees_of(report.rotary_travel);
    summary["retracts"] = report.retracts;
    summary["branch_changes"] = report.branch_changes;
    summary["singular_points"] = report.singular_points;
    summary["rows"] = motion.rows;
    summary["pieces"] = report.pieces;
    summary["max_tip_error_mm"] = report.max_tip_error_mm;
    summary["max_axis_error_deg"] = degrees_of(report.max_axis_error);
    summary["max_tip_feed_mm_per_min"] = report.max_tip_feed_mm_per_min;
    summary["rate_limited_min"] = report.rate_limited_min;
    Json xyz = Json::object();
    for (int axis = 0; axis < 3; ++axis)
        xyz[std::string(1, "xyz"[axis])] = {motion.xyz_range.low[axis],
                                            motion.xyz_range.high[axis]};
    summary["xyz_range_mm"] = xyz;
    Json turns = Json::object();
    const auto& rotary = motion.machine.setup.machine.configuration.rotary;
    for (std::size_t k = 0; k < rotary.size(); ++k)
        turns[std::string(1, rotary[k].letter)] = {
            degrees_of(motion.rotary_range[k].least.value_or(0)),
            degrees_of(motion.rotary_range[k].greatest.value_or(0))};
    summary["rotary_range_deg"] = turns;
    summary["rounding_tip_mm"] = motion.rounding_tip_mm;
}

// A line about the motions of the machine; empty for a program without rotary axes.
std::string motion_text(const PostedPath& posted)
{
    if (!posted.motion)
        return "";
    const MachinePathReport& report = posted.motion->report;
    return fmt::format(
        "  motion      {} in {}, rotary travel {} degrees, {}, tip within {} mm\n",
        counted(posted.motion->rows, "point"), counted(report.pieces, "piece"),
        shown(degrees_of(report.rotary_travel)), counted(report.retracts, "retract"),
        shown_bound(report.max_tip_error_mm));
}

}  // namespace

Json post_summary(const PostedPath& posted, const PostOptions& options)
{
    const WrittenProgram& written = posted.written;
    Json summary{{"name", posted.name},
                 {"endmill", program_version},
                 {"format", word_of(options.format)},
                 {"file", printable(posted.file)},
                 {"units", "mm"},
                 {"programmed_point", "tip"},
                 {"points", posted.read.path.points.size()},
                 {"repeated_points", written.repeated_points},
                 {"slanted_rapids", written.slanted_rapids},
                 {"lines", written.lines},
                 {"bytes", written.text.size()},
                 {"tape_length_m", written.tape_length_m()},
                 {"decimals", written.decimals},
                 {"max_rounding_error_mm", written.max_rounding_error_mm},
                 {"position_error_mm", posted.read.position_error_mm}};
    add_interpreter(summary, options.path);
    add_path_totals(summary, written.totals);
    identify_path(summary, posted.read.path.points.size(), content_sha256(written.text));
    add_source_path(summary, options.path.file, options.common.limits);
    add_range(summary, "feed_mm_per_min", written.feed_mm_per_min);
    add_range(summary, "plunge_feed_mm_per_min", written.plunge_feed_mm_per_min);
    add_range(summary, "spindle_rpm", written.spindle_rpm);
    if (posted.control)
        add_gcode_keys(summary, posted, options);
    summary["interpolation"] = written.arcs > 0 ? "linear and circular" : "linear";
    if (posted.motion) {
        add_machine_motion(summary, posted.motion->machine);
        add_motion_keys(summary, *posted.motion, options);
    }
    summary["cutter"] =
        posted.known.cutter ? Json(cutter_word(*posted.known.cutter)) : Json(nullptr);
    summary["cutters"] = cutters_json(posted.tools);
    add_known(summary, "chord_tolerance_mm", posted.known.chord_tolerance_mm);
    add_known(summary, "inner_tolerance_mm", posted.known.inner_tolerance_mm);
    add_known(summary, "outer_tolerance_mm", posted.known.outer_tolerance_mm);
    add_known(summary, "scallop_mm", posted.known.scallop_mm);
    if (posted.known.inaccessible)
        summary["inaccessible"] = inaccessible_name(*posted.known.inaccessible);
    summary["remarks"] = posted.read.remarks;
    return summary;
}

std::string post_text(const Json& s, const PostedPath& posted, const PostOptions& options)
{
    const std::string language =
        posted.control ? "G-code for " + posted.control->name : "APT CL data";
    const std::size_t arcs = posted.written.arcs;
    return fmt::format(
        "{}: {}, {}, {}{}, within {} mm of the path\n"
        "{}"
        "{}"
        "  feed        {}\n"
        "{}",
        s["name"].get<std::string>(), s["file"].get<std::string>(), language,
        counted(posted.written.lines, "line"),
        arcs > 0 ? ", " + counted(arcs, "arc") : "",
        shown_bound(std::max(posted.written.max_rounding_error_mm,
                             posted.written.max_arc_error_mm)),
        path_totals_text(s), motion_text(posted), conditions_text(s),
        descents_text(posted, options));
}

}  // namespace endmill
