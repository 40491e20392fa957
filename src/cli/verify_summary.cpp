// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_summary.h"
#include "cli/path_tools.h"

#include <algorithm>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/text.h"

#include "endmill/core/tolerance.h"

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
    summary["inaccessible_area_mm2"] = d.inaccessible_area_mm2;
    summary["max_inaccessible_mm"] = finite_or_null(d.max_inaccessible_mm);
    summary["gouge_bound_mm"] = finite_or_null(d.gouge_bound_mm);
    summary["scallop_bound_mm"] = finite_or_null(d.scallop_bound_mm);
    summary["bound_mm"] = finite_or_null(std::max(d.gouge_bound_mm, d.scallop_bound_mm));
    summary["gouge_bound_refined"] = refined.gouge_is_refined;
    summary["scallop_bound_refined"] = refined.scallop_is_refined;
    summary["rays"] = d.rays;
}

void add_no_deviation(Json& summary)
{
    for (const char* key :
         {"max_gouge_mm", "max_gouge_at", "gouge_area_mm2", "max_scallop_mm",
          "max_scallop_at", "p99_scallop_mm", "mean_scallop_mm", "uncut_area_mm2",
          "judged_area_mm2", "inaccessible_area_mm2", "max_inaccessible_mm",
          "gouge_bound_mm", "scallop_bound_mm", "bound_mm", "gouge_bound_refined",
          "scallop_bound_refined", "rays"})
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
    const bool cuts = deepest != removal.deepest.end() && *deepest > touching_depth;
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
    const auto& on_part = verification.on_part;
    const PartCollisions found = on_part ? on_part->collisions : PartCollisions{};
    add_count(summary, "part_collisions", found.moves);
    Json place = nullptr;
    if (found.deepest)
        place = {{"point_mm", vector_json(found.deepest->point)},
                 {"point", found.deepest->move}};
    summary["deepest_of_part_collisions_at"] = place;
    summary["part_collision_error_mm"] = finite_or_null(found.error_mm);
    summary["part_collision_bound_mm"] = finite_or_null(found.bound_mm);
    if (!on_part)
        for (const char* key : {"part_collisions", "deepest_of_part_collisions_mm",
                                "part_collision_error_mm", "part_collision_bound_mm"})
            summary[key] = nullptr;
}

// Adds the gouges of earlier runs. They are null if the history of the stock is known.
void add_earlier(Json& summary, const Verification& verification)
{
    const auto& on_part = verification.on_part;
    const EarlierGouge* earlier =
        on_part && on_part->earlier_gouge ? &*on_part->earlier_gouge : nullptr;
    summary["earlier_moves"] =
        verification.earlier_moves ? Json(*verification.earlier_moves) : Json(nullptr);
    summary["earlier_gouge_mm"] = earlier ? finite_or_null(earlier->found_mm) : nullptr;
    summary["earlier_gouge_at"] =
        earlier && earlier->found_at ? vector_json(*earlier->found_at) : Json(nullptr);
    summary["earlier_gouge_bound_mm"] =
        earlier ? finite_or_null(earlier->bound_mm) : nullptr;
}

// Adds the accuracy of the removal by dexels, and contacts that are possible only; null
// with three axes.
void add_five_axis(Json& summary, const Verification& verification)
{
    const auto& bounds = verification.removed_bounds;
    summary["engine"] = bounds ? "five-axis" : "three-axis";
    summary["removed_bound_mm3"] = bounds ? Json(bounds->bound) : Json(nullptr);
    summary["removed_spread_mm3"] = bounds ? Json(bounds->spread) : Json(nullptr);
    const StockContacts& contacts = verification.contacts;
    summary["possible_contact_mm"] = bounds ? Json(contacts.possible_mm) : Json(nullptr);
    summary["first_of_possible_contacts"] =
        contacts.first_possible ? Json(*contacts.first_possible) : Json(nullptr);
}

// Adds the range of the stock along x and y.
void add_stock_extent(Json& summary, const Verification& verification)
{
    if (const auto* dexels = std::get_if<DexelStock>(&verification.rest)) {
        const Block& block = dexels->block();
        summary["min_x_mm"] = block.low.x();
        summary["max_x_mm"] = block.high.x();
        summary["min_y_mm"] = block.low.y();
        summary["max_y_mm"] = block.high.y();
        return;
    }
    const StockGrid& grid = std::get<HeightStock>(verification.rest).grid();
    summary["min_x_mm"] = grid.low_x;
    summary["max_x_mm"] = grid.low_x + grid.columns * grid.pitch;
    summary["min_y_mm"] = grid.low_y;
    summary["max_y_mm"] = grid.low_y + grid.rows * grid.pitch;
}

std::string length_text(const Json& mm)
{
    return mm.is_null() ? "unknown" : shown(mm.get<double>()) + " mm";
}

std::string bound_length(const Json& mm)
{
    return mm.is_null() ? "unknown" : shown_bound(mm.get<double>()) + " mm";
}

// The place, and the point to which the move goes.
std::string place_text(const Json& place)
{
    if (place.is_null())
        return "";
    const Json& at = place["point_mm"];
    std::string text = fmt::format(
        " at x {} y {} z {}", shown_coordinate(at[0].get<double>()),
        shown_coordinate(at[1].get<double>()), shown_coordinate(at[2].get<double>()));
    if (place.value("earlier_run", false))
        text += ", by an earlier run";
    else if (!place["point"].is_null())
        text += fmt::format(", point {}", place["point"].get<int>());
    return text;
}

// A bound that was not refined describes the pitch of the first rays, not the cut
// surface.
std::string bound_text(const Json& greatest, const Json& over, const Json& is_refined)
{
    if (!is_refined.get<bool>())
        return "bound not refined: it cannot change the verdict";
    if (greatest.is_null() || over.is_null())
        return "bound unknown";
    return "bound " + shown_bound(greatest.get<double>() + over.get<double>()) + " mm";
}

// A value with enough digits to see on which side of its limit it lies, and on which side
// of the limit raised by the slack, which decides.
std::string value_text(double value, double limit)
{
    const std::string one = shown_against(value, limit);
    const std::string other = shown_against(value, limit + verdict_slack);
    return one.size() > other.size() ? one : other;
}

std::string extreme_text(const Json& s, const std::string& key, const char* limit_key)
{
    const Json& greatest = s["max_" + key + "_mm"];
    const double limit = s[limit_key].get<double>();
    return fmt::format(
        "{}, {} {} + {} mm{}; {}",
        greatest.is_null() ? "unknown" : value_text(greatest.get<double>(), limit),
        key == "gouge" ? "tolerance" : "limit", shown_limit(limit),
        to_text(verdict_slack), place_text(s["max_" + key + "_at"]),
        bound_text(greatest, s[key + "_bound_mm"], s[key + "_bound_refined"]));
}

// The stock that the cutter cannot reach; empty without any.
std::string inaccessible_text(const Json& s)
{
    const Json& area = s["inaccessible_area_mm2"];
    if (area.is_null() || !(area.get<double>() > 0))
        return "";
    const Json& cutter = s["cutter"];  // null for several tools
    return fmt::format(
        "; not judged: {} mm2 that {} touch, with up to {} remaining",
        shown(area.get<double>()),
        cutter.is_null() ? "no tool can" : cutter.get<std::string>() + " cannot",
        length_text(s["max_inaccessible_mm"]));
}

// Gouges of earlier runs at the heights of the stock, and a bound between the heights;
// empty if the history of the stock is known.
std::string earlier_text(const Json& s)
{
    if (s["earlier_gouge_mm"].is_null())
        return "";
    return fmt::format(
        "; stock gouged {} deep by earlier runs, at most {} deeper between its heights",
        length_text(s["earlier_gouge_mm"]), bound_length(s["earlier_gouge_bound_mm"]));
}

std::string deviation_text(const Json& s)
{
    const auto area = [&](const char* key) { return shown(s[key].get<double>()); };
    return fmt::format(
        "  gouge       {}; {} of {} mm2 gouged{}\n"
        "  remaining   {}; {} mm2 uncut; on average {}\n",
        extreme_text(s, "gouge", "tolerance_mm"), area("gouge_area_mm2"),
        area("judged_area_mm2"), earlier_text(s),
        extreme_text(s, "scallop", "scallop_limit_mm"), area("uncut_area_mm2"),
        length_text(s["mean_scallop_mm"]));
}

// "ball:6", or "T1 flat:10, T2 ball:6".
std::string used_cutters(const Json& s)
{
    if (s["cutters"].is_null())
        return s["cutter"].get<std::string>();
    std::string text;
    for (const Json& tool : s["cutters"])
        text += fmt::format("{}T{} {}", text.empty() ? "" : ", ", tool["tool"].get<int>(),
                            tool["cutter"].get<std::string>());
    return text;
}

// The width of contacts of rapids, shank and holder that the resolution may miss.
std::string contacts_text(const StockContacts& contacts)
{
    if (!(contacts.width_mm > 0))
        return "";
    return fmt::format(
        "; contacts of rapids, shank and holder narrower than {} mm may be missed",
        shown(contacts.width_mm));
}

// What an undecided verdict needs.
std::string undecided_text(const Json& s)
{
    if (!s["earlier_gouge_mm"].is_null())
        return "a limit may be broken between the rays, or between the heights of the "
               "stock: use a finer --resolution, and a stock.vti that keeps its moves";
    return "a limit may be broken between the rays: use a finer --resolution";
}

// The verdict and its grounds, apart from the limits of the deviation.
std::string verdict_text(const Json& s, const VerifyOptions& options,
                         const Verification& verification)
{
    std::string text =
        s["name"].get<std::string>() + ": " + s["verdict"].get<std::string>();
    std::vector<std::string> grounds = broken_rules(verification);
    if (verification.verdict == Verdict::Undecided)
        grounds.push_back(undecided_text(s));
    if (verification.verdict == Verdict::NotJudged)
        grounds.emplace_back(options.part.path == no_part
                                 ? "no part is compared (--part none)"
                                 : "no part to compare with; --part FILE names one");
    if (verification.verdict == Verdict::NotJudged && s["removed_mm3"] == 0)
        grounds.emplace_back(
            "the stock lies below the path: --stock sets where the material is");
    for (const std::string& ground : grounds)
        text += (&ground == grounds.data() ? ": " : "; ") + ground;
    return text + inaccessible_text(s) + "\n";
}

std::string removal_text(const Json& s, const StockContacts& contacts)
{
    const auto moves = s["points"].get<std::size_t>() - 1;
    const auto air = s["air_moves"].get<std::size_t>();
    std::string error;
    if (const Json& bound = s["removed_bound_mm3"]; !bound.is_null())
        error = fmt::format(" +- {}", shown_bound(bound.get<double>()));
    std::string text =
        fmt::format("  removed     {}{} mm3 by {} in {} of {}; deepest cut {}",
                    shown(s["removed_mm3"].get<double>()), error, used_cutters(s),
                    moves - std::min(air, moves), counted(moves, "move"),
                    length_text(s["deepest_cut_mm"]));
    const Json& greatest = s["max_rate_mm3_per_min"];
    const Json& mean = s["mean_rate_mm3_per_min"];
    if (!greatest.is_null() && !mean.is_null())
        text += fmt::format("; at most {} mm3/min, on average {} mm3/min",
                            shown(greatest.get<double>()), shown(mean.get<double>()));
    return text + contacts_text(contacts) + "\n";
}

}  // namespace

std::vector<std::string> broken_rules(const Verification& verification)
{
    const Removal& removal = verification.removal;
    std::vector<std::string> rules;
    const auto& [rapids, first_rapid, depth] = removal.rapid_cuts;
    if (rapids > 0)
        rules.push_back(fmt::format(
            "{} {}, up to {} mm deep, the first to point {}", counted(rapids, "rapid"),
            rapids == 1 ? "cuts" : "cut", shown(depth), first_rapid.value_or(0)));
    const auto& [hits, first_hit, inside] = removal.collisions;
    if (hits > 0)
        rules.push_back(fmt::format(
            "shank or holder enters the material up to {} mm, on {}, the first to point "
            "{}",
            shown(inside), counted(hits, "move"), first_hit.value_or(0)));
    const StockContacts& contacts = verification.contacts;
    if (contacts.possible_mm > ignored_contact)
        rules.push_back(fmt::format(
            "a rapid, shank or holder may enter the material by up to {} mm, the first "
            "on "
            "the move to point {}",
            shown_bound(contacts.possible_mm), contacts.first_possible.value_or(0)));
    if (!verification.on_part)
        return rules;
    const PartCollisions& in_part = verification.on_part->collisions;
    if (in_part.deepest)
        rules.push_back(fmt::format(
            "shank or holder enters the part up to {} mm, on {}, the first to point {}; "
            "deepest at x {} y {} z {}, point {}",
            shown(in_part.moves.deepest), counted(in_part.moves.count, "move"),
            in_part.moves.first.value_or(0), shown_coordinate(in_part.deepest->point.x()),
            shown_coordinate(in_part.deepest->point.y()),
            shown_coordinate(in_part.deepest->point.z()), in_part.deepest->move));
    else if (may_be_in_part(in_part))
        rules.push_back(
            fmt::format("shank or holder may enter the part by up to {} mm: no contact "
                        "was found, but "
                        "contacts are not excluded",
                        shown_bound(in_part.bound_mm)));
    return rules;
}

std::string cutter_words(const Cutter& first, const std::vector<NumberedTool>& tools)
{
    if (tools.size() < 2)
        return cutter_word(first);
    std::string text;
    for (const auto& [number, tool] : tools)
        text += fmt::format("{}T{} {}", text.empty() ? "" : ", ", number,
                            cutter_word(tool.cutter));
    return text;
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
        {"cutter",
         context.tools.size() < 2 ? Json(cutter_word(context.cutter)) : Json(nullptr)},
        {"cutters", cutters_json(context.tools)},
        {"tool", options.tool.empty() ? Json(nullptr) : Json(printable(options.tool))},
        {"points", context.program.path.points.size()},
        {"verdict", std::string{verdict_name(verification.verdict)}},
        {"tolerance_mm", context.limits.tolerance},
        {"scallop_limit_mm", context.limits.scallop},
        {"slack_mm", verdict_slack},
        {"resolution_mm", options.resolution},
        {"max_refine", options.max_refine}};
    if (const auto& on_part = verification.on_part; on_part && charts)
        add_deviation(summary, on_part->deviation,
                      refined_bounds(on_part->deviation, context.limits), *charts);
    else
        add_no_deviation(summary);
    add_path_totals(summary, path_totals(context.program.path));
    add_removal(summary, verification.removal, context.program.path);
    summary["contact_width_bound_mm"] = verification.contacts.width_mm;
    add_five_axis(summary, verification);
    add_earlier(summary, verification);
    add_part_collisions(summary, verification);
    add_stock_extent(summary, verification);
    summary["position_error_mm"] = context.program.position_error_mm;
    summary["remarks"] = context.program.remarks;
    return summary;
}

namespace {

std::string protected_text(const Json& s)
{
    if (!s.contains("protected"))
        return {};
    return fmt::format("  protected   {}: gouge {} mm (limit {})\n",
                       s["protected"].get<std::string>(),
                       shown_against(s["protected_max_gouge_mm"].get<double>(),
                                     s["tolerance_mm"].get<double>()),
                       shown_limit(s["tolerance_mm"].get<double>()));
}

std::string skipped_text(const Json& s)
{
    if (!s.contains("skipped"))
        return {};
    std::string why =
        s.contains("skip_facets") ? s["skip_facets"].get<std::string>() : "";
    if (s.contains("cut_faces"))
        why += (why.empty() ? "" : " and of ") + std::string{"faces that are not cut"};
    return fmt::format("  not judged  remaining stock on {} of {}\n",
                       counted(s["skipped"].get<std::size_t>(), "facet"), why);
}

}  // namespace

std::string verify_text(const Json& s, const VerifyOptions& options,
                        const Verification& verification)
{
    const bool is_compared = !s["part"].is_null();
    return verdict_text(s, options, verification) +
           (is_compared ? deviation_text(s) : "") + protected_text(s) + skipped_text(s) +
           removal_text(s, verification.contacts) + path_totals_text(s) +
           (is_compared ? "" : "  extent      " + extent_text(s) + "\n");
}

}  // namespace endmill
