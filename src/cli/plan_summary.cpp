// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_summary.h"

#include <algorithm>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/surface_facts.h"
#include "endmill/core/text.h"

namespace endmill {

namespace {

void add_motion(Json& summary, const PlannedDirection& planned)
{
    const MotionError& error = planned.motion_error;
    summary["max_motion_error_mm"] = error.greatest_mm();
    summary["max_motion_gouge_mm"] = error.gouge.greatest_mm;
    summary["max_motion_left_mm"] = error.remaining.greatest_mm;
    summary["motion_error_bound_mm"] = error.bound_mm;
    summary["lifted_links"] = planned.lifted_links;
    summary["uncovered_places"] = planned.uncovered.size();
}

// Deviation of the whole part after the straight motions.
void add_deviation(Json& summary, const Deviation& deviation)
{
    summary["max_gouge_mm"] = deviation.max_gouge_mm;
    summary["gouge_area_mm2"] = deviation.gouge_area_mm2;
    summary["max_scallop_mm"] = finite_or_null(deviation.max_scallop_mm);
    summary["p99_scallop_mm"] = finite_or_null(deviation.p99_scallop_mm);
    summary["mean_scallop_mm"] = finite_or_null(deviation.mean_scallop_mm);
    summary["uncut_area_mm2"] = deviation.uncut_area_mm2;
    summary["scallop_pitch_mm"] = deviation.pitch_mm;
    summary["scallop_bound_mm"] =
        finite_or_null(std::max(deviation.gouge_bound_mm, deviation.scallop_bound_mm));
}

}  // namespace

PathErrors PlannedDirection::errors() const
{
    return path_errors(chord_error, motion_error, deviation.max_gouge_mm,
                       deviation.max_scallop_mm);
}

Json direction_summary(const PlanContext& context, const PlanOptions& options,
                       const PlannedDirection& planned)
{
    const PathEconomy& economy = planned.economy;
    const auto travel = [&](TravelKind kind) {
        return counted_travel(economy, kind, options.counted);
    };
    Json summary{{"name", context.name},
                 {"source", context.source},
                 {"endmill", program_version},
                 {"direction", planned.along == Parameter::U ? "u" : "v"},
                 {"mode", mode_word(options.mode)},
                 {"cutter", cutter_word(context.cutter)},
                 {"passes", economy.passes},
                 {"ncl", economy.ncl},
                 {"tcd_mm", travel(TravelKind::Contact)},
                 {"tcd_cl_mm", travel(TravelKind::Tip)},
                 {"link_mm", economy.link.contact_mm}};
    if (options.feed_mm_per_min) {
        summary["feed_mm_per_min"] = *options.feed_mm_per_min;
        summary["time_min"] = travel(options.distance) / *options.feed_mm_per_min;
    }
    summary["tape_length_m"] =
        planned.tape_length_m ? Json(*planned.tape_length_m) : Json(nullptr);
    add_cutter_limit(summary, context.limit, context.several);
    add_continuity(summary, context.continuity, context.several);
    summary["max_chord_error_mm"] = planned.chord_error.greatest_mm;
    summary["chord_error_pitch_mm"] = planned.chord_error.pitch_mm;
    add_motion(summary, planned);
    add_deviation(summary, planned.deviation);
    summary["interpolation"] = "linear";
    add_policies(summary, options);
    return summary;
}

void add_comparison(Json& both, const PlanOptions& options, const PlannedDirection& u,
                    const PlannedDirection& v)
{
    const auto cost = [&](const PlannedDirection& planned) -> DirectionCost {
        return {planned.economy.ncl,
                counted_travel(planned.economy, options.distance, options.counted)};
    };
    const DirectionComparison comparison = compare_directions(cost(u), cost(v));
    both["recommended"] = comparison.recommended == Parameter::U ? "u" : "v";
    both["reduction_ncl"] = comparison.reduction_ncl;
    both["reduction_tcd"] = comparison.reduction_tcd;
}

}  // namespace endmill
