// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_strategy.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/facet_list.h"
#include "cli/path_facts.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/bound/path_bound.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/tool_path_svg.h"
#include "endmill/figures/travel_svg.h"
#include "endmill/files/csv.h"
#include "endmill/files/path_file.h"
#include "endmill/files/vtk.h"
#include "endmill/planning/economy.h"
#include "endmill/strategy/plan_frame.h"
#include "endmill/strategy/strategy.h"
#include "endmill/strategy/strip_use.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Memory of the bound of a mesh.
constexpr double bytes_a_facet = 700;
// How long bounding takes, as a multiple of planning.
constexpr double bounding_share = 0.1;

// Lengths of the moves that leave contact, by tips, mm.
struct AirTravel {
    double lifted = 0;  // over the safe height, and the first plunge
    double arched = 0;  // over an obstacle at feed
};

AirTravel air_travel(const ToolPath& path)
{
    AirTravel travel;
    const std::span<const PathPoint> points{path.points};
    // after a retract, a link leads across an arch
    const auto is_across = [&](std::size_t k) {
        return k > 0 && k < points.size() && points[k].move == Move::Link &&
               points[k - 1].move == Move::Retract;
    };
    for (std::size_t k = 1; k < points.size(); ++k) {
        const bool is_arch = is_across(k) || is_across(k - 1) ||
                             (points[k].move == Move::Retract && is_across(k + 1));
        const bool is_at_feed =
            points[k].move == Move::Cut || points[k].move == Move::Link;
        const double length =
            (points[k].location.tip - points[k - 1].location.tip).norm();
        if (is_arch)
            travel.arched += length;
        else if (!is_at_feed)
            travel.lifted += length;
    }
    return travel;
}

Json tried_json(const std::vector<TriedStrategy>& tried)
{
    Json list = Json::array();
    for (const auto& [strategy, travel_mm, estimated_mm, refusal] : tried) {
        Json one{{"strategy", strategy_name(strategy)}};
        one["cut_mm"] = travel_mm ? Json(*travel_mm) : Json(nullptr);
        if (estimated_mm)
            one["estimated_mm"] = *estimated_mm;
        if (!refusal.empty())
            one["refusal"] = refusal;
        list.push_back(std::move(one));
    }
    return list;
}

Json summary_of(const PlanTask& task, const BestPlan& chosen,
                const StrategyOptions& limits)
{
    const auto& [part, surfaces, context, options, guard, frame, skipped, in_mesh] = task;
    const auto& [strategy, covering, economy, deviation, verdict, of_protected] =
        chosen.plan;
    const AirTravel air = air_travel(covering.path);
    Json summary{
        {"name", context.name},
        {"source", context.source},
        {"endmill", program_version},
        {"strategy", strategy_name(strategy)},
        {"mode", mode_word(options.mode)},
        {"cutter", cutter_word(context.cutter)},
        {"passes", covering.passes},
        {"pieces", covering.pieces},
        {"ncl", economy.ncl},
        {"cut_contact_mm",
         context.cutter.is_ball() ? Json(economy.cut.contact_mm) : Json(nullptr)},
        {"cut_tip_mm", economy.cut.tip_mm},
        {"link_mm", economy.link.tip_mm},
        {"lifted_mm", air.lifted},
        {"lifted_links", covering.lifted_links},
        {"arched_mm", air.arched},
        {"arched_links", covering.arched_links},
        {"scallop_mm", limits.scallop_height},
        {"inner_tolerance_mm", limits.inner_tolerance},
        {"outer_tolerance_mm", 0}};
    if (covering.direction)
        summary["direction_deg"] = covering.direction->written_degrees();
    if (!chosen.tried.empty())
        summary["tried"] = tried_json(chosen.tried);
    if (options.feed_mm_per_min) {
        summary["feed_mm_per_min"] = *options.feed_mm_per_min;
        summary["time_min"] =
            (economy.cut.tip_mm + economy.link.tip_mm) / *options.feed_mm_per_min;
    }
    if (context.is_mesh || guard) {
        summary["unreached_mm2"] = covering.unreached_mm2;
        summary["inaccessible"] = inaccessible_name(InaccessibleStock::Report);
        summary["inaccessible_area_mm2"] = deviation.inaccessible_area_mm2;
    }
    if (!context.is_mesh && context.cutter.is_ball())
        add_cutter_limit(summary, context.limit, context.several);
    if (!context.is_mesh)
        add_continuity(summary, context.continuity, context.several);
    summary["max_gouge_mm"] = deviation.max_gouge_mm;
    summary["gouge_bound_mm"] = finite_or_null(deviation.gouge_bound_mm);
    summary["max_left_mm"] = finite_or_null(deviation.max_scallop_mm);
    summary["left_bound_mm"] = finite_or_null(deviation.scallop_bound_mm);
    if (of_protected) {
        summary["protected_max_gouge_mm"] = of_protected->max_gouge_mm;
        summary["protected_gouge_bound_mm"] =
            finite_or_null(of_protected->gouge_bound_mm);
    }
    summary["verdict"] = verdict_name(verdict);
    summary["uncovered_mm2"] = covering.uncovered_mm2;
    summary["uncovered_places"] = covering.uncovered.size();
    summary["interpolation"] = "linear";
    summary["safe_height_mm"] = options.planning.link.safe_height;
    summary["axis"] = vector_json(options.planning.link.axis);
    return summary;
}

// The number of places at which a path covers a disc without travel in contact: after each
// plunge, and after each link at feed that is shorter than `disc_mm`. A longer link pays for
// its disc.
std::size_t free_discs(const ToolPath& path, double disc_mm)
{
    std::size_t discs = 0;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        const bool is_short_link =
            point.move == Move::Link && point.contact() &&
            (point.location.tip - path.points[k - 1].location.tip).norm() < disc_mm;
        discs += point.move == Move::Plunge || is_short_link ? 1 : 0;
    }
    return discs;
}

// Compares all travel at feed by tips with a bound by tips.
void add_total_bound(Json& summary, const ToolPath& path, const PathBound& bound)
{
    const double least =
        bound.density_mm -
        static_cast<double>(free_discs(path, bound.disc_mm)) * bound.disc_mm;
    const double total =
        summary["cut_tip_mm"].get<double>() + summary["link_mm"].get<double>();
    summary["total_over_bound"] = least > 0 ? Json(total / least) : Json(nullptr);
}

// Compares the number of points with the least one of every path that covers the part.
void add_points_bound(Json& summary, const BoundProblem& problem, const PlanTask& task,
                      std::span<const double> sides)
{
    const PointsBound bound = points_bound(task.surfaces, sides, problem);
    summary["points_estimate"] = static_cast<std::int64_t>(bound.points);
    summary["points_grade"] = bound_grade_name(bound.grade);
    if (bound.grade == BoundGrade::Closed)
        summary["points_over_bound"] = summary["ncl"].get<double>() / bound.points;
}

// A mesh as it stands while it is planned.
TriangleMesh turned(const TriangleMesh& mesh, const Eigen::Matrix3d& part_to_machine)
{
    std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
    for (Vec3& point : points)
        point = part_to_machine * point;
    return {std::move(points), {mesh.triangles().begin(), mesh.triangles().end()}};
}

// Compares the length of the cuts with the bound for every path that covers the part.
// \return the density of the bound; empty if there is none.
std::vector<DensityCorners> add_bound(Json& summary, const PlanTask& task,
                                      const CoveringPath& covering,
                                      ProgressLine& progress)
{
    progress.begin("bounding the length");
    const std::vector<double> sides =
        tool_side_signs(task.surfaces, task.options.planning.link.axis);
    BoundProblem problem{task.context.ball(), task.options.planning.scallop_height};
    // On a mesh contacts have no bound.
    const bool is_by_tips =
        task.context.is_mesh || task.options.distance == TravelKind::Tip;
    const char* cut_key = is_by_tips ? "cut_tip_mm" : "cut_contact_mm";
    problem.length = is_by_tips ? BoundedLength::Tip : BoundedLength::Contact;
    problem.stray = covering.stray_mm;
    problem.most_pieces = static_cast<int>(covering.pieces);
    EstimateOptions estimate;
    estimate.progress = progress.shower();
    if (task.options.bound == PlanBound::Certified)
        estimate.grade = BoundGrade::Certified;
    summary["bound_gamma_mm"] = covering.stray_mm;
    summary["bound_distance"] = is_by_tips ? "cl" : "contact";
    const auto set_none = [&](const std::string& reason) {
        for (const char* key : {"bound_density_mm", "bound_disc_mm", "bound_mm",
                                "bound_grade", "travel_over_bound"})
            summary[key] = nullptr;
        summary["bound_reason"] = reason;
        return std::vector<DensityCorners>{};
    };
    summary["points_estimate"] = nullptr;
    const auto* mesh = std::get_if<TriangleMesh>(&task.part);
    if (covering.unreached_mm2 > 0 && (!mesh || task.guard))
        return set_none("there is no bound where a protected part bars places");
    if (mesh && bytes_a_facet * static_cast<double>(mesh->triangles().size()) >
                    task.options.common.limits.max_memory_gib * one_gib)
        return set_none("the bound of so many facets needs more than --max-memory");
    if (mesh && task.options.bound == PlanBound::Certified)
        return set_none("the bound of a mesh can only be estimated");
    if (!mesh)
        add_points_bound(summary, problem, task, sides);
    try {
        PathBound bound =
            mesh ? mesh_bound(turned(*mesh, task.part_to_machine), problem, estimate)
                 : path_bound(task.surfaces, sides, problem, estimate);
        summary["bound_density_mm"] = bound.density_mm;
        summary["bound_disc_mm"] = bound.disc_mm;
        summary["bound_mm"] = bound.bound_mm ? Json(*bound.bound_mm) : Json(nullptr);
        summary["bound_grade"] = bound_grade_name(bound.grade);
        summary["travel_over_bound"] =
            bound.bound_mm ? Json(summary[cut_key].get<double>() / *bound.bound_mm)
                           : Json(nullptr);
        if (is_by_tips)
            add_total_bound(summary, covering.path, bound);
        if (!bound.bound_mm)
            summary["bound_reason"] =
                "the part is little larger than what the ball covers at rest";
        return std::move(bound.density);
    } catch (const GeometryError& error) {
        // there is none for a part with creases, and not always a certificate
        return set_none(error.what());
    }
}

std::string bound_text(const Json& s)
{
    if (!s.contains("bound_mm"))
        return {};
    if (s["bound_mm"].is_null())
        return fmt::format("  lower bound   none: {}\n",
                           s["bound_reason"].get<std::string>());
    return fmt::format(
        "  lower bound   {} mm by {} ({}); the cuts are {:.3f} times as long\n",
        shown(s["bound_mm"].get<double>()),
        s["bound_distance"] == "cl" ? "tips" : "contacts",
        s["bound_grade"].get<std::string>(), s["travel_over_bound"].get<double>());
}

std::string protected_text(const Json& s, const DeviationLimits& limits)
{
    if (!s.contains("protected_max_gouge_mm"))
        return {};
    return fmt::format(
        "  protected     gouge {} mm (limit {}); it bars {} mm2 of the part\n",
        shown_against(s["protected_max_gouge_mm"].get<double>(), limits.tolerance),
        shown_limit(limits.tolerance), shown(s["unreached_mm2"].get<double>()));
}

// Why strategies have no path, one line for each reason.
std::string refusals_text(const Json& tried)
{
    std::vector<std::pair<std::string, std::string>> names_by_reason;
    for (const Json& one : tried) {
        if (!one.contains("refusal"))
            continue;
        const auto reason = one["refusal"].get<std::string>();
        const auto strategy = one["strategy"].get<std::string>();
        const auto known = std::ranges::find(names_by_reason, reason,
                                             &std::pair<std::string, std::string>::first);
        if (known == names_by_reason.end())
            names_by_reason.emplace_back(reason, strategy);
        else
            known->second += ", " + strategy;
    }
    std::string text;
    for (const auto& [reason, names] : names_by_reason)
        text += fmt::format("  no path       {}: {}\n", names, reason);
    return text;
}

std::string tried_text(const Json& s)
{
    if (!s.contains("tried"))
        return {};
    const auto length = [](const Json& one) -> std::string {
        if (!one["cut_mm"].is_null())
            return shown(one["cut_mm"].get<double>()) + " mm";
        if (one.contains("estimated_mm"))
            return "about " + shown(one["estimated_mm"].get<double>()) + " mm";
        return "no path";
    };
    std::string text;
    for (const Json& one : s["tried"])
        text += fmt::format("{} {} {}", text.empty() ? "  tried        " : ",",
                            one["strategy"].get<std::string>(), length(one));
    return text + "\n" + refusals_text(s["tried"]);
}

std::string report(const Json& s, const CoveringPath& plan, const DeviationLimits& limits)
{
    const auto number = [&](const char* key) { return s[key].get<double>(); };
    const std::string left = s["max_left_mm"].is_null()
                                 ? "unknown"
                                 : shown_against(number("max_left_mm"), limits.scallop);
    return fmt::format(
               "  {}   {} passes in {}, {}; cut {}{} mm by tips, links "
               "{} mm, "
               "{} arched, {} lifted\n"
               "  judged        {}: gouge {} mm (limit {}), remaining {} mm (limit "
               "{}){}\n",
               s["strategy"].get<std::string>(), s["passes"].get<std::size_t>(),
               counted(plan.pieces, "piece"),
               counted(s["ncl"].get<std::size_t>(), "point"),
               s["cut_contact_mm"].is_null()
                   ? std::string{}
                   : shown(number("cut_contact_mm")) + " mm by contacts, ",
               shown(number("cut_tip_mm")), shown(number("link_mm")), plan.arched_links,
               plan.lifted_links, s["verdict"].get<std::string>(),
               shown_against(number("max_gouge_mm"), limits.tolerance),
               shown_limit(limits.tolerance), left, shown_limit(limits.scallop),
               plan.uncovered.empty()
                   ? std::string{}
                   : fmt::format("; not covered: {}",
                                 counted(plan.uncovered.size(), "place"))) +
           protected_text(s, limits) + tried_text(s) + bound_text(s);
}

// The figure's title and caption.
FigureOptions strategy_figure(const Json& s)
{
    FigureOptions figure;
    figure.title =
        fmt::format("{}: {} in cutting order, {}", s["name"].get<std::string>(),
                    s["cut_contact_mm"].is_null() ? "tips" : "contact points",
                    s["strategy"].get<std::string>());
    figure.captions = {fmt::format(
        "{}, scallop height {:g} mm, {} points", s["cutter"].get<std::string>(),
        s["scallop_mm"].get<double>(), s["ncl"].get<std::size_t>())};
    if (!s["cut_contact_mm"].is_null())
        figure.captions.emplace_back(
            "use: width that a cut newly covers, as a share of the strip on a plane");
    return figure;
}

// How much of their strips the cuts use; nothing where it is not known.
std::vector<double> shown_strip_use(const PlanTask& task, const ToolPath& path)
{
    const Vec3& axis = task.options.planning.link.axis;
    if (!task.context.cutter.is_ball() ||
        (axis - Vec3::UnitZ()).norm() > unit_vector_rounding)
        return {};
    return strip_use(task.part, path, task.context.ball(),
                     task.options.planning.scallop_height);
}

void warn_of_uncovered(const CoveringPath& plan, const CommonOptions& options)
{
    if (plan.uncovered.empty())
        return;
    const UncoveredPlace& first = plan.uncovered.front();
    warn(options,
         fmt::format("more than the scallop height may remain at {}, together "
                     "{} mm2; the first is at {} of patch {}",
                     counted(plan.uncovered.size(), "place"), shown(plan.uncovered_mm2),
                     place_text(first.at, first.point), first.patch));
}

std::string angles_csv(const std::vector<ComparedDirection>& compared)
{
    CsvTable table{{"angle_deg", "cut_contact_mm", "cut_tip_mm", "passes"}};
    for (const auto& [direction, cut_contact_mm, cut_tip_mm, passes] : compared)
        table.add_row({direction.written_degrees(),
                       cut_contact_mm ? CsvCell{*cut_contact_mm} : CsvCell{}, cut_tip_mm,
                       static_cast<std::int64_t>(passes)});
    return table.text();
}

// Writes the lengths in all directions that were compared.
void write_directions(const CoveringPath& covering, const Json& s, OutputFolder& folder)
{
    if (covering.compared.empty())
        return;
    std::vector<DirectionTravel> travel;
    for (const auto& [direction, cut_contact_mm, cut_tip_mm, passes] : covering.compared)
        travel.push_back({direction, cut_contact_mm, cut_tip_mm});
    TravelFigure figure;
    figure.title = s["name"].get<std::string>() + ": length of passes in upright planes";
    figure.captions = {fmt::format(
        "{}, scallop height {:g} mm; by coarse trials; chosen: {:.4g} degrees",
        s["cutter"].get<std::string>(), s["scallop_mm"].get<double>(),
        covering.direction->degrees())};
    folder.write("angles.csv", angles_csv(covering.compared));
    folder.write("angles.svg", direction_travel_svg(travel, figure));
}

// Draws the density of the bound.
void write_density(const std::vector<DensityCorners>& density, const Json& s,
                   OutputFolder& folder)
{
    if (density.empty())
        return;
    std::vector<DensityPiece> pieces;
    pieces.reserve(density.size());
    for (const auto& [points, mean_per_mm] : density)
        pieces.push_back({points, mean_per_mm});
    FigureOptions figure;
    figure.title = s["name"].get<std::string>() + ": density of the lower bound";
    figure.captions = {
        fmt::format("{}, scallop height {:g} mm", s["cutter"].get<std::string>(),
                    s["scallop_mm"].get<double>()),
        "length of cuts that every path needs for each mm2 of the part"};
    folder.write("density.svg", density_svg(pieces, figure));
}

// Warns of places that the ball cannot reach.
void warn_of_unreached(const CoveringPath& plan, const PlanTask& task)
{
    if (!(plan.unreached_mm2 > 0))
        return;
    const std::string why =
        task.options.guard.path.empty() ? "of the mesh, such as concave corners"
        : task.context.is_mesh ? "of the mesh, such as concave corners or beside the "
                                 "protected part"
                               : "beside the protected part";
    warn(task.options.common,
         fmt::format("the ball cannot reach {} mm2 {}; they need not be covered",
                     shown(plan.unreached_mm2), why));
}

// Names the files besides the part that the plan depends on.
void name_inputs(Json& summary, const PlanTask& task, const OutputFolder& folder)
{
    const PlanOptions& options = task.options;
    if (!options.guard.path.empty())
        name_protected_part(summary, options.guard, folder.path(), options.common.limits);
    name_cut_facets(summary, task, folder.path());
    if (!options.setup.empty())
        name_part(summary, {options.setup}, folder.path(), "setup");
}

}  // namespace

std::optional<Strategy> chosen_strategy(StrategyChoice strategy)
{
    switch (strategy) {
        case StrategyChoice::IsoU:
            return Strategy::IsoU;
        case StrategyChoice::IsoV:
            return Strategy::IsoV;
        case StrategyChoice::Planar:
            return Strategy::Planar;
        case StrategyChoice::IsoScallop:
            return Strategy::IsoScallop;
        case StrategyChoice::Field:
            return Strategy::Field;
        case StrategyChoice::Iso:
        case StrategyChoice::Best:
            break;
    }
    return std::nullopt;
}

PlanResult write_strategy_plan(const PlanTask& task, OutputFolder& folder)
{
    const auto& [part, surfaces, context, options, guard, frame, skipped, in_mesh] = task;
    replace_earlier_plans(folder);
    StrategyOptions strategy;
    strategy.scallop_height = options.planning.scallop_height;
    strategy.inner_tolerance = options.motion.inner;
    strategy.link = options.planning.link;
    strategy.most_points = options.planning.most_points;
    strategy.most_samples = most_part_samples(options.common.limits.max_memory_gib);
    strategy.distance = options.distance;
    strategy.direction = options.pass_direction;
    ProgressLine progress{"planning", options.common, bounding_share};
    strategy.progress = progress.shower();
    BestPlan chosen = plan_in_frame({frame, guard}, chosen_strategy(options.strategy),
                                    part, context.cutter, strategy);
    CoveringPath& covering = chosen.plan.covering;
    warn_of_uncovered(covering, options.common);
    warn_of_unreached(covering, task);
    number_points(covering.path);
    const DeviationLimits limits{strategy.inner_tolerance, strategy.scallop_height};
    Json summary = summary_of(task, chosen, strategy);
    std::vector<DensityCorners> density;
    if (options.bound != PlanBound::None && context.cutter.is_ball())
        density = add_bound(summary, task, covering, progress);
    add_path_totals(summary["path"], path_totals(covering.path));
    summary["path"]["points"] = covering.path.points.size();
    name_part(summary, options.part, folder.path());
    name_inputs(summary, task, folder);
    const std::string table = tool_path_csv(covering.path);
    identify_path(summary, covering.path.points.size(), content_sha256(table));
    folder.write("toolpath.csv", table);
    folder.write("toolpath.vtp", tool_path_vtp(covering.path));
    const std::vector<double> use = shown_strip_use(task, covering.path);
    folder.write("toolpath.svg", tool_path_svg(covering.path, strategy_figure(summary),
                                               PathDrawing{&part, use}));
    write_directions(covering, summary, folder);
    write_density(density, summary, folder);
    folder.write("summary.json", summary.dump(2) + "\n");
    PlanResult result{
        summary, report(summary, covering, limits), covering.uncovered.size(), {}};
    result.is_undecided = chosen.plan.verdict != Verdict::Clean;
    return result;
}

}  // namespace endmill
