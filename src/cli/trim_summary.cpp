// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_summary.h"

#include <algorithm>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/path_interval.h"
#include "endmill/trimming/trimming.h"

namespace endmill {
namespace {

Json or_null(const std::optional<double>& value)
{
    return value ? finite_or_null(*value) : Json(nullptr);
}

// Adds the points, the totals and the heights of the path.
void add_path(Json& summary, const CutPart& part, const TrimOptions& options,
              const TrimResult& result)
{
    summary["points"] = result.path.points.size();
    add_path_totals(summary, path_totals(result.path));
    summary["thinned_points"] = result.dropped_points;
    summary["thinned_within_mm"] = result.thin_tolerance;
    summary["safe_height_mm"] = safe_height(part, options);
    const std::optional<double> pitch = pick_feed(part.planes);
    summary["pitch_mm"] = or_null(pitch);
    summary["level_scallop_mm"] =
        or_null(pitch ? level_scallop_height(*options.cutter, *pitch) : std::nullopt);
    if (options.scallop)
        summary["scallop_mm"] = *options.scallop;
    // The limits by which `verify` judges the path.
    summary["inner_tolerance_mm"] = options.tolerance;
    if (const auto* mesh = std::get_if<DroppedPart>(&part.shape)) {
        summary["outer_tolerance_mm"] = options.tolerance;
        summary["added_planes"] = mesh->added_planes;
        summary["inaccessible"] = inaccessible_name(InaccessibleStock::Report);
    }
}

void add_counts(Json& summary, const TrimResult& result)
{
    std::size_t curves = 0;
    std::size_t points = 0;
    std::size_t loops = 0;
    for (const Trimmed& plane : result.trimmed) {
        curves += plane.curves.size();
        for (const TrimmedCurve& curve : plane.curves)
            points += curve.points.size();
    }
    for (const auto& plane : result.loops)
        loops += plane.size();
    summary["planes"] = result.trimmed.size();
    summary["curves"] = curves;
    summary["trimmed_points"] = points;
    summary["loops"] = loops;
    summary["unresolved"] = unresolved(result);
}

}  // namespace

std::size_t unresolved(const TrimResult& result)
{
    std::size_t count = 0;
    for (const Trimmed& plane : result.trimmed)
        count += static_cast<std::size_t>(plane.unresolved);
    return count;
}

std::optional<double> max_gouge(const TrimResult& result)
{
    if (!result.min_clearance)
        return std::nullopt;
    return std::max(0.0, -*result.min_clearance);
}

Json trim_summary(const TrimInput& input, const TrimOptions& options,
                  const TrimResult& result)
{
    Json summary{{"name", input.name},
                 {"source", input.source},
                 {"endmill", program_version},
                 {"method", result.method}};
    const OffsetPart* const surfaces = input.offset_part();
    if (const std::optional<Cutter>& cutter = cutter_of(options))
        summary["cutter"] = cutter_word(*cutter);
    if (input.part)
        summary["remarks"] = input.remarks;
    add_counts(summary, result);
    summary["offset_ms"] = surfaces ? Json(surfaces->offset_ms) : Json(nullptr);
    summary["slice_ms"] = input.part ? Json(input.part->slice_ms) : Json(nullptr);
    summary["trim_ms"] = result.trim_ms;
    if (result.comparison) {
        summary["wrong_sections"] = result.comparison->wrong;
        summary["max_below_envelope_mm"] = result.comparison->max_gouge_mm;
    }
    summary["min_clearance_mm"] = or_null(result.min_clearance);
    summary["max_gouge_mm"] = or_null(max_gouge(result));
    if (surfaces) {
        summary["sampling_error_mm"] = or_null(result.sampling_error);
        summary["refine"] = options.refine;
        if (result.unrefined)
            summary["unrefined"] = *result.unrefined;
    }
    add_settings(summary, options, result.options);
    if (input.part) {
        add_path(summary, *input.part, options, result);
        summary["interpolation"] = "linear";
    }
    return summary;
}

namespace {

// The points of the path, or of curves those that are left.
std::string points_text(const Json& s)
{
    if (!s.contains("cut_mm"))
        return counted(s["trimmed_points"].get<std::size_t>(), "point");
    std::string text = "path of " + counted(s["points"].get<std::size_t>(), "point");
    if (const auto dropped = s["thinned_points"].get<std::size_t>())
        text += fmt::format(", {} more within {} mm of a chord", dropped,
                            shown_limit(s["thinned_within_mm"].get<double>()));
    return text;
}

// The line about the scallop height; empty if --scallop is not given.
std::string scallop_text(const Json& s)
{
    if (!s.contains("scallop_mm"))
        return "";
    std::string text =
        fmt::format("  scallop     {} mm", shown_limit(s["scallop_mm"].get<double>()));
    if (!s.contains("added_planes"))
        return text + " where the part is horizontal\n";
    const auto added = s["added_planes"].get<std::size_t>();
    return text + (added > 0 ? fmt::format(", by {} more on slopes and at walls\n",
                                           counted(added, "plane"))
                             : "\n");
}

}  // namespace

std::string trim_text(const Json& s)
{
    std::string text = fmt::format(
        "method {}: {} removed from {} in {} ms; {}\n", s["method"].get<std::string>(),
        counted(s["loops"].get<std::size_t>(), "loop"),
        counted(s["planes"].get<std::size_t>(), "section"),
        shown_time(s["trim_ms"].get<double>()), points_text(s));
    if (s.contains("cut_mm"))
        text += path_totals_text(s);
    if (!s["min_clearance_mm"].is_null())
        text += fmt::format("  clearance   {} mm (limit -{} mm)\n",
                            shown_against(s["min_clearance_mm"].get<double>(),
                                          -s["tolerance_mm"].get<double>()),
                            shown_limit(s["tolerance_mm"].get<double>()));
    text += scallop_text(s);
    if (const auto left = s["unresolved"].get<std::size_t>())
        text += fmt::format("  folds       {} left\n", left);
    return text;
}

std::string methods_text(const Json& methods)
{
    constexpr const char* row = "{:<10}{:>10}{:>8}{:>10}{:>12}{:>8}{:>19}{:>14}\n";
    std::string text =
        fmt::format(row, "method", "time ms", "loops", "points", "folds left", "wrong",
                    "below envelope mm", "clearance mm");
    for (const auto& [name, s] : methods.items()) {
        const Json& clearance = s["min_clearance_mm"];
        text += fmt::format(
            row, name, shown_time(s["trim_ms"].get<double>()),
            s["loops"].get<std::size_t>(), s["trimmed_points"].get<std::size_t>(),
            s["unresolved"].get<std::size_t>(), s["wrong_sections"].get<std::size_t>(),
            shown(s["max_below_envelope_mm"].get<double>()),
            clearance.is_null() ? "" : shown(clearance.get<double>()));
    }
    return text +
           "wrong: sections that step back, or lie more than --tolerance below the upper "
           "envelope\n";
}

}  // namespace endmill
