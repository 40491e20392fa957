// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_summary.h"

#include <algorithm>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

Json deviation_place(const std::optional<DeviationPlace>& place, const PartCharts& charts)
{
    if (!place)
        return nullptr;
    Json json;
    if (charts.mesh())
        json["triangle"] = charts.source(place->chart);
    else
        json = {{"u", place->at.x()},
                {"v", place->at.y()},
                {"patch", charts.source(place->chart)}};
    json["point_mm"] = vector_json(place->ray.point);
    json["point"] = place->sweep >= 0 ? Json(place->sweep) : Json(nullptr);
    json["earlier_run"] = place->sweep == by_earlier_run;
    return json;
}

void add_deviation(Json& summary, const Deviation& d, const RefinedBounds& refined,
                   const PartCharts& charts)
{
    summary["max_gouge_mm"] = d.max_gouge_mm;
    summary["max_gouge_at"] = deviation_place(d.deepest, charts);
    summary["gouge_area_mm2"] = d.gouge_area_mm2;
    summary["max_scallop_mm"] = finite_or_null(d.max_scallop_mm);
    summary["max_scallop_at"] = deviation_place(d.highest, charts);
    summary["p99_scallop_mm"] = finite_or_null(d.p99_scallop_mm);
    summary["mean_scallop_mm"] = finite_or_null(d.mean_scallop_mm);
    summary["uncut_area_mm2"] = d.uncut_area_mm2;
    summary["judged_area_mm2"] = d.area_mm2;
    summary["gouge_bound_mm"] = finite_or_null(d.gouge_bound_mm);
    summary["scallop_bound_mm"] = finite_or_null(d.scallop_bound_mm);
    summary["bound_mm"] = finite_or_null(std::max(d.gouge_bound_mm, d.scallop_bound_mm));
    summary["gouge_bound_refined"] = refined.gouge;
    summary["scallop_bound_refined"] = refined.scallop;
    summary["rays"] = d.rays;
}

void add_no_deviation(Json& summary)
{
    for (const char* key :
         {"max_gouge_mm", "max_gouge_at", "gouge_area_mm2", "max_scallop_mm",
          "max_scallop_at", "p99_scallop_mm", "mean_scallop_mm", "uncut_area_mm2",
          "judged_area_mm2", "gouge_bound_mm", "scallop_bound_mm", "bound_mm",
          "gouge_bound_refined", "scallop_bound_refined", "rays"})
        summary[key] = nullptr;
}

void add_count(Json& summary, const std::string& key, const MoveCount& moves)
{
    summary[key] = moves.count;
    summary["first_of_" + key] = moves.first ? Json(*moves.first) : Json(nullptr);
    summary["deepest_of_" + key + "_mm"] = moves.deepest;
}

void add_removal(Json& summary, const Removal& removal, const ToolPath& path)
{
    summary["removed_mm3"] = removal.total;
    const auto deepest = std::ranges::max_element(removal.deepest);
    const bool cuts = deepest != removal.deepest.end() && *deepest > least_cut_depth;
    summary["deepest_cut_mm"] = cuts ? *deepest : 0;
    summary["deepest_cut_point"] =
        cuts ? Json(deepest - removal.deepest.begin()) : Json(nullptr);
    const auto rates = removal_rates(removal, path);
    summary["max_rate_mm3_per_min"] = rates ? Json(rates->greatest) : Json(nullptr);
    summary["mean_rate_mm3_per_min"] = rates ? Json(rates->mean) : Json(nullptr);
    summary["min_z_mm"] = removal.left ? Json(removal.left->low) : Json(nullptr);
    summary["max_z_mm"] = removal.left ? Json(removal.left->high) : Json(nullptr);
    summary["air_moves"] = removal.air_moves;
    add_count(summary, "rapid_cuts", removal.rapid_cuts);
    add_count(summary, "collisions", removal.collisions);
}

void add_part_collisions(Json& summary, const Verification& verification)
{
    const PartCollisions found = verification.part_collisions.value_or(PartCollisions{});
    add_count(summary, "part_collisions", found.moves);
    Json place = nullptr;
    if (found.deepest)
        place = {{"point_mm", vector_json(found.deepest->point)},
                 {"point", found.deepest->move}};
    summary["deepest_of_part_collisions_at"] = place;
    summary["part_collision_error_mm"] = finite_or_null(found.error_mm);
    summary["part_collision_bound_mm"] = finite_or_null(found.bound_mm);
    if (!verification.part_collisions)
        for (const char* key : {"part_collisions", "deepest_of_part_collisions_mm",
                                "part_collision_error_mm", "part_collision_bound_mm"})
            summary[key] = nullptr;
}

// Nothing is left open where the stock's history is known.
void add_earlier(Json& summary, const Verification& verification)
{
    const std::optional<EarlierGouge>& earlier = verification.earlier_gouge;
    summary["earlier_moves"] =
        verification.earlier_moves ? Json(*verification.earlier_moves) : Json(nullptr);
    summary["earlier_gouge_mm"] = earlier ? finite_or_null(earlier->found_mm) : nullptr;
    summary["earlier_gouge_at"] =
        earlier && earlier->found_at ? vector_json(*earlier->found_at) : Json(nullptr);
    summary["earlier_gouge_bound_mm"] =
        earlier ? finite_or_null(earlier->bound_mm) : nullptr;
}

std::string number_text(const Json& value)
{
    return value.is_null() ? "unknown" : fmt::format("{:.4g}", value.get<double>());
}

std::string area_text(const Json& value)
{
    return fmt::format("{:.6g} mm2", value.get<double>());
}

// Where, and on the way to which point.
std::string place_text(const Json& place)
{
    if (place.is_null())
        return "";
    const Json& at = place["point_mm"];
    std::string text = fmt::format(" at {:.4g}, {:.4g}, {:.4g}", at[0].get<double>(),
                                   at[1].get<double>(), at[2].get<double>());
    if (place.value("earlier_run", false))
        text += " by an earlier run";
    else if (!place["point"].is_null())
        text += fmt::format(" on the move to point {}", place["point"].get<int>());
    return text;
}

// A bound of the first rays alone says how coarse they are, not what was done.
std::string between_text(const Json& bound, const Json& is_refined)
{
    return is_refined.get<bool>()
               ? "between rays at most " + number_text(bound) + " mm more"
               : "not looked for between the rays, as this is settled";
}

std::string extremes_text(const Json& s)
{
    return fmt::format(
        "deepest gouge {} mm{} ({}; tolerance {:g} mm)\n"
        "highest rest {} mm{} ({}; limit {:g} mm)\n",
        number_text(s["max_gouge_mm"]), place_text(s["max_gouge_at"]),
        between_text(s["gouge_bound_mm"], s["gouge_bound_refined"]),
        s["tolerance_mm"].get<double>(), number_text(s["max_scallop_mm"]),
        place_text(s["max_scallop_at"]),
        between_text(s["scallop_bound_mm"], s["scallop_bound_refined"]),
        s["scallop_limit_mm"].get<double>());
}

std::string areas_text(const Json& s)
{
    return fmt::format(
        "of {}, {} are gouged and {} uncut; the rest of material is {} mm on average, on "
        "99 % of the area below {} mm\n",
        area_text(s["judged_area_mm2"]), area_text(s["gouge_area_mm2"]),
        area_text(s["uncut_area_mm2"]), number_text(s["mean_scallop_mm"]),
        number_text(s["p99_scallop_mm"]));
}

// What rapids, shank and holder may do unseen.
std::string contacts_text(const StockContacts& contacts)
{
    if (!(contacts.width_mm > 0))
        return "";
    return fmt::format(
        "a cut by a rapid, or by shank or holder, that is narrower than {:.3g} mm seen "
        "from above may be missed\n",
        contacts.width_mm);
}

// The heights of a stock, and what may lie between them.
std::string earlier_text(const Json& s)
{
    return fmt::format(
        "the stock was gouged {} mm deep before, at most {} mm more between its "
        "heights\n",
        number_text(s["earlier_gouge_mm"]), number_text(s["earlier_gouge_bound_mm"]));
}

// What has to be known to read the verdict.
std::string hint_text(const Json& s)
{
    if (s["verdict"] == verdict_name(Verdict::Undecided) &&
        !s["earlier_gouge_mm"].is_null())
        return "a limit may be broken between the rays, or between the stock's heights: "
               "a "
               "finer --resolution tells, and a stock.vti that keeps its moves\n";
    if (s["verdict"] == verdict_name(Verdict::Undecided))
        return "a limit may be broken between the rays: a finer --resolution tells\n";
    if (s["part"].is_null() && s["removed_mm3"] == 0)
        return "the stock lies below the path: --stock says where the material is\n";
    return "";
}

}  // namespace

RefinedBounds refined_bounds(const Deviation& deviation, const DeviationLimits& limits)
{
    const bool is_gouged = deviation.max_gouge_mm > limits.tolerance + verdict_slack;
    const bool is_uncut = deviation.max_scallop_mm > limits.scallop + verdict_slack;
    return {!is_gouged, !is_gouged && !is_uncut};
}

std::vector<std::string> broken_rules(const Verification& verification)
{
    const Removal& removal = verification.removal;
    std::vector<std::string> rules;
    const auto& [rapids, first_rapid, depth] = removal.rapid_cuts;
    if (rapids > 0)
        rules.push_back(fmt::format("{} cut, up to {:.4g} mm deep, the first to point {}",
                                    counted(rapids, "rapid"), depth,
                                    first_rapid.value_or(0)));
    const auto& [hits, first_hit, inside] = removal.collisions;
    if (hits > 0)
        rules.push_back(fmt::format(
            "shank or holder is up to {:.4g} mm in the material, on {}, the first to "
            "point {}",
            inside, counted(hits, "move"), first_hit.value_or(0)));
    const PartCollisions in_part =
        verification.part_collisions.value_or(PartCollisions{});
    if (in_part.deepest)
        rules.push_back(fmt::format(
            "shank or holder is up to {:.4g} mm in the part, on {}, the first to point "
            "{}; deepest at {:.4g}, {:.4g}, {:.4g} on the move to point {}",
            in_part.moves.deepest, counted(in_part.moves.count, "move"),
            in_part.moves.first.value_or(0), in_part.deepest->point.x(),
            in_part.deepest->point.y(), in_part.deepest->point.z(),
            in_part.deepest->move));
    else if (in_part.bound_mm > closed_contact_bound)
        rules.push_back(fmt::format(
            "shank or holder may be up to {:.4g} mm in the part, for all that is known",
            in_part.bound_mm));
    return rules;
}

Json verify_summary(const VerifyContext& context, const VerifyOptions& options,
                    const Verification& verification, const PartCharts* charts)
{
    Json summary{
        {"name", context.name},
        {"endmill", program_version},
        {"toolpath", printable(options.path.file)},
        {"part", context.part.empty() ? Json(nullptr) : Json(context.part)},
        {"stock", context.stock},
        {"cutter", cutter_word(context.cutter)},
        {"tool", options.tool.empty() ? Json(nullptr) : Json(printable(options.tool))},
        {"points", context.program.path.points.size()},
        {"verdict", std::string{verdict_name(verification.verdict)}},
        {"tolerance_mm", context.limits.tolerance},
        {"scallop_limit_mm", context.limits.scallop},
        {"slack_mm", verdict_slack},
        {"resolution_mm", options.resolution},
        {"max_refine", options.max_refine}};
    if (verification.deviation && charts)
        add_deviation(summary, *verification.deviation,
                      refined_bounds(*verification.deviation, context.limits), *charts);
    else
        add_no_deviation(summary);
    add_removal(summary, verification.removal, context.program.path);
    summary["contact_width_bound_mm"] = verification.contacts.width_mm;
    add_earlier(summary, verification);
    add_part_collisions(summary, verification);
    const StockGrid& grid = verification.rest.grid();
    summary["min_x_mm"] = grid.low_x;
    summary["max_x_mm"] = grid.low_x + grid.columns * grid.pitch;
    summary["min_y_mm"] = grid.low_y;
    summary["max_y_mm"] = grid.low_y + grid.rows * grid.pitch;
    summary["position_error_mm"] = context.program.position_error_mm;
    summary["remarks"] = context.program.remarks;
    return summary;
}

std::string verify_text(const Json& s, const Verification& verification)
{
    std::string text = fmt::format("{}: {}\n", s["name"].get<std::string>(),
                                   s["verdict"].get<std::string>());
    if (s["part"].is_null())
        text += "no part to judge by: --part FILE names one\n";
    else
        text += extremes_text(s) + areas_text(s);
    if (verification.earlier_gouge)
        text += earlier_text(s);
    for (const std::string& rule : broken_rules(verification))
        text += rule + "\n";
    text += contacts_text(verification.contacts);
    text += fmt::format("removed {:.6g} mm3; {} of {} moves cut nothing\n",
                        s["removed_mm3"].get<double>(), s["air_moves"].get<std::size_t>(),
                        s["points"].get<std::size_t>() - 1);
    text += fmt::format(
        "deepest cut {:.4g} mm; removal rate {} mm3/min at most, {} on "
        "average\n",
        s["deepest_cut_mm"].get<double>(), number_text(s["max_rate_mm3_per_min"]),
        number_text(s["mean_rate_mm3_per_min"]));
    return text + hint_text(s);
}

}  // namespace endmill
