// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_summary.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

Json number_or_null(const std::optional<double>& number)
{
    return number ? Json(*number) : Json(nullptr);
}

Json file_or_null(const std::string& file)
{
    return file.empty() ? Json(nullptr) : Json(printable(file));
}

// The part by which `verify` judges the written path: the given part, or else the one
// that the path was planned for.
void add_part(Json& summary, const FeedResult& result)
{
    PartOptions part = result.options.part;
    if (const auto& known = result.input.known.part; part.path.empty() && known)
        part = {known->file.string(), known->units, known->up};
    summary["part"] = nullptr;
    if (!part.path.empty())
        name_part(summary, part, result.folder);
    if (const auto& guard = result.input.known.protected_part)
        name_part(summary, {guard->file.string(), guard->units, guard->up}, result.folder,
                  "protected");
}

void add_tool(Json& summary, const FeedInput& input)
{
    const MillingTool& tool = input.job.tool;
    summary["cutter"] = cutter_word(input.tool.cutter);
    summary["flutes"] = tool.flutes;
    summary["helix_deg"] =
        input.tool.helix ? Json(input.tool.helix->written_degrees()) : Json(nullptr);
    summary["max_force_n"] = number_or_null(tool.limits.cutting_force_n);
    summary["max_thrust_n"] = number_or_null(tool.limits.thrust_n);
    summary["max_tool_torque_n_m"] = number_or_null(tool.limits.torque_n_m);
}

void add_choices(Json& summary, const FeedResult& result)
{
    const FeedCommandOptions& options = result.options;
    const FeedPlanOptions& plan = result.input.plan;
    const FeedRules rules = feed_rules(result.input.job, plan);
    summary["mode"] = word_for<FeedMode>(options.mode, feed_modes);
    summary["chip"] = word_for<ChipModel>(plan.chip, chip_models);
    summary["peak"] = peak_word(plan.peak, plan.peak_factor);
    summary["engagement"] =
        word_for<EngagementChoice>(options.engagement, engagement_choices);
    summary["first_pass"] = word_for<PreviousPass>(options.first_pass, first_passes);
    summary["coefficients"] =
        word_for<CoefficientSource>(options.coefficients, coefficient_sources);
    if (options.coefficients == CoefficientSource::Table)
        summary["table_error"] = table_error;
    summary["accuracy"] = plan.accuracy;
    summary["stock"] = printable(options.stock);
    summary["stock_top_mm"] = result.input.stock_top;
    summary["stock_top_by"] = result.input.stock_top_by;
    summary["contact_tolerance_mm"] = options.contact_tolerance;
    summary["max_feed_per_tooth_mm"] = number_or_null(rules.range.most_mm);
    summary["min_feed_per_tooth_mm"] = rules.range.least_mm;
    summary["block_time_ms"] = plan.block_time_ms;
    summary["plunge_feed_mm_per_min"] = options.plunge_feed_mm_per_min;
    summary["rapid_mm_per_min"] = number_or_null(options.rapid_mm_per_min);
    summary["constant_feed_mm_per_min"] =
        number_or_null(options.constant_feed_mm_per_min);
    if (options.mode == FeedMode::Planned)
        summary["corner_tolerance_mm"] = options.corner_tolerance;
    if (options.engagement == EngagementChoice::Stock)
        summary["resolution_mm"] = options.resolution;
    add_reading(summary, options.path);
}

void add_times(Json& summary, const FeedResult& result)
{
    const FeedTimes& times = result.times;
    summary["cut_min"] = times.cut_min;
    summary["noncut_min"] = number_or_null(times.noncut_min);
    summary["total_min"] = number_or_null(times.total_min);
    summary["constant_feed_min"] = number_or_null(times.constant_feed_min);
    summary["saving_percent"] = number_or_null(times.saving_percent);
    if (result.planned_min)
        summary["planned_min"] = *result.planned_min;
}

void add_plan(Json& summary, const FeedPlanTotals& totals)
{
    Json limits;
    for (const FeedLimit limit : all_feed_limits)
        limits[std::string{feed_limit_name(limit)}] =
            totals.limit_shares[static_cast<std::size_t>(limit)];
    Json speed_limits;
    for (const SpeedLimit limit : all_speed_limits)
        speed_limits[std::string{speed_limit_name(limit)}] =
            totals.speed_limit_shares[static_cast<std::size_t>(limit)];
    summary["limits"] = limits;
    summary["infeasible"] = totals.infeasible;
    summary["speed_limits"] = speed_limits;
    summary["max_torque_n_m"] = totals.max_torque_n_m;
    summary["max_power_w"] = totals.max_power_w;
    summary["needed_limits"] = {
        {"cutting_force_n", number_or_null(totals.needed.cutting_force_n)},
        {"thrust_n", number_or_null(totals.needed.thrust_n)},
        {"torque_n_m", number_or_null(totals.needed.torque_n_m)}};
}

// The keys that `verify` and `post` read from the summary of a path.
void add_known(Json& summary, const FeedResult& result)
{
    const FeedInput& input = result.input;
    const auto add = [&](const char* key, const std::optional<double>& value) {
        if (value)
            summary[key] = *value;
    };
    add("chord_tolerance_mm", input.known.chord_tolerance_mm);
    add("inner_tolerance_mm", input.known.inner_tolerance_mm);
    add("outer_tolerance_mm", input.known.outer_tolerance_mm);
    add("scallop_mm", input.known.scallop_mm);
    if (input.known.inaccessible)
        summary["inaccessible"] = inaccessible_name(*input.known.inaccessible);
    summary["interpolation"] = "linear";
    summary["remarks"] = result.remarks;
}

// The words of the limits in feed.svg, by their keys.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10>
    limit_names_in_words{{{"cutting_force", "force across the tool axis"},
                          {"thrust", "force along the tool axis"},
                          {"torque", "torque"},
                          {"cap", "feed per tooth of the material"},
                          {"block_rate", "time of a block"},
                          {"infeasible", "no feasible feed"},
                          {"economic_speed", "tool life"},
                          {"spindle", "spindle speed"},
                          {"power", "spindle power"},
                          {"feed_drive", "feed drive"}}};

// "tool life 62.5 %, spindle speed 37.5 %": the limits that govern, with their shares.
std::string shares_text(const Json& shares)
{
    std::string text;
    for (const auto& [key, share] : shares.items()) {
        const auto words = std::ranges::find(limit_names_in_words, key,
                                             [](const auto& pair) { return pair.first; });
        if (share.get<double>() > 0)
            text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ",
                                words == limit_names_in_words.end() ? key : words->second,
                                100 * share.get<double>());
    }
    return text;
}

std::string minutes(const Json& value)
{
    return shown_time(value.get<double>()) + " min";
}

std::string times_text(const Json& s)
{
    std::string text = "  time          " + minutes(s["cut_min"]) + " of cutting";
    if (!s["total_min"].is_null())
        text += fmt::format(", {} in all with {} of other moves", minutes(s["total_min"]),
                            minutes(s["noncut_min"]));
    if (!s["saving_percent"].is_null())
        text += fmt::format("; saving {:.1f} % against {} mm/min",
                            s["saving_percent"].get<double>(),
                            to_text(s["constant_feed_mm_per_min"].get<double>()));
    if (s.contains("planned_min"))
        text += "; " + minutes(s["planned_min"]) +
                " of cutting with the acceleration of the machine";
    return text + "\n";
}

}  // namespace

Json feed_summary(const FeedResult& result)
{
    const FeedInput& input = result.input;
    Json summary{{"name", input.name},
                 {"endmill", program_version},
                 {"toolpath", printable(result.options.path.file)},
                 {"material", printable(result.options.material)},
                 {"machine", file_or_null(result.options.machine)},
                 {"tool", file_or_null(result.options.tool.file)}};
    add_part(summary, result);
    add_tool(summary, input);
    add_choices(summary, result);
    summary["points"] = result.cuts.fed.path().points.size();
    const std::size_t segments = result.cuts.points.size();
    summary["segments"] = segments;
    const bool is_by_stock = result.options.engagement == EngagementChoice::Stock;
    summary["segments_by_contact"] = is_by_stock ? 0 : result.cuts.by_contact;
    summary["segments_by_passes"] = is_by_stock ? 0 : result.cuts.by_passes;
    summary["segments_by_stock"] = is_by_stock ? segments : 0;
    summary["zero_length_segments"] = result.cuts.zero_length;
    summary["cut_mm"] = result.cuts.totals.length_mm;
    add_times(summary, result);
    add_plan(summary, result.cuts.totals);
    add_known(summary, result);
    return summary;
}

std::string feed_text(const Json& s)
{
    std::string text = fmt::format(
        "{}: mode {}, {} mm of cut in {}; top of the stock z {} mm ({})\n",
        s["name"].get<std::string>(), s["mode"].get<std::string>(),
        shown(s["cut_mm"].get<double>()),
        counted(s["segments"].get<std::size_t>(), "segment"),
        shown(s["stock_top_mm"].get<double>()), s["stock_top_by"].get<std::string>());
    text += times_text(s);
    text += "  feed limits   " + shares_text(s["limits"]) + " of the length\n";
    text += "  speed limits  " + shares_text(s["speed_limits"]) + " of the length\n";
    if (s["mode"] == "paper")
        text +=
            "  better mode   --mode corrected uses the exact chip and the loads within a "
            "spindle revolution\n";
    return text;
}

std::string infeasible_text(const Json& s)
{
    std::string text = fmt::format(
        "no feed of at least {:g} mm per tooth satisfies the limits on {} of {}",
        s["min_feed_per_tooth_mm"].get<double>(), s["infeasible"].get<std::size_t>(),
        counted(s["segments"].get<std::size_t>(), "segment"));
    const char* separator = "; expected at least ";
    const auto add = [&](const char* key, const char* limit, const char* unit) {
        const Json& needed = s["needed_limits"][key];
        if (needed.is_null())
            return;
        text += fmt::format("{}{} {} {}", separator, limit, to_text(needed.get<double>()),
                            unit);
        separator = ", ";
    };
    add("cutting_force_n", "cutting_force", "N");
    add("thrust_n", "thrust", "N");
    add("torque_n_m", "torque", "N m");
    return text + " (--max-force-n, --max-thrust-n, --max-torque-n-m)";
}

}  // namespace endmill
