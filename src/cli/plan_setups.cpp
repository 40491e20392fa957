// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_setups.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/facet_list.h"
#include "cli/path_facts.h"
#include "cli/plan_strategy.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/tool_path_svg.h"
#include "endmill/files/path_file.h"
#include "endmill/files/setup_file.h"
#include "endmill/files/vtk.h"
#include "endmill/orientation/indexed_plan.h"

namespace endmill {
namespace {

IndexedOptions indexed_options(const PlanTask& task, SetupDirections setups)
{
    const PlanOptions& options = task.options;
    IndexedOptions indexed;
    indexed.directions = std::move(setups.axes);
    indexed.skipped = task.skipped;
    indexed.strategy = chosen_strategy(options.strategy);
    indexed.scallop_height = options.planning.scallop_height;
    indexed.inner_tolerance = options.motion.inner;
    indexed.distance = options.distance;
    indexed.most_points = options.planning.most_points;
    indexed.most_samples = most_part_samples(options.common.limits.max_memory_gib);
    return indexed;
}

// What is known of one direction.
Json direction_json(const IndexedCut& cut, const IndexedOptions& options)
{
    Json one{{"direction", cut.direction},
             {"axis", vector_json(options.directions[cut.direction])},
             {"facets", cut.facets.size()}};
    if (!cut.best) {
        one["refusal"] = cut.refusal;
        return one;
    }
    const StrategyPlan& plan = cut.best->plan;
    one["strategy"] = strategy_name(plan.strategy);
    one["passes"] = plan.covering.passes;
    one["cut_contact_mm"] = plan.economy.cut.contact_mm;
    one["unreached_mm2"] = plan.covering.unreached_mm2;
    one["uncovered_mm2"] = plan.covering.uncovered_mm2;
    one["max_gouge_mm"] = plan.of_protected ? plan.of_protected->max_gouge_mm : 0;
    one["max_left_mm"] = finite_or_null(plan.deviation.max_scallop_mm);
    one["verdict"] = verdict_name(plan.verdict);
    return one;
}

Json indexed_summary(const PlanTask& task, const IndexedPlan& plan,
                     const IndexedOptions& indexed)
{
    const PlanOptions& options = task.options;
    Json by_direction = Json::array();
    double cut_mm = 0;
    std::size_t passes = 0;
    for (const IndexedCut& cut : plan.cuts) {
        by_direction.push_back(direction_json(cut, indexed));
        cut_mm += cut.best ? cut.best->plan.economy.cut.contact_mm : 0;
        passes += cut.best ? cut.best->plan.covering.passes : 0;
    }
    return {{"name", task.context.name},
            {"source", task.context.source},
            {"endmill", program_version},
            {"strategy", strategy_word(options.strategy)},
            {"cutter", cutter_word(task.context.cutter)},
            {"passes", passes},
            {"cut_contact_mm", cut_mm},
            {"scallop_mm", options.planning.scallop_height},
            {"inner_tolerance_mm", options.motion.inner},
            {"outer_tolerance_mm", 0},
            {"directions", std::move(by_direction)},
            {"joined_regions", plan.joined_regions},
            {"skipped", task.skipped.size()},
            {"uncovered_facets", plan.uncovered},
            {"is_good", plan.is_good()},
            {"inaccessible", std::string{inaccessible_name(InaccessibleStock::Report)}},
            {"interpolation", "linear"}};
}

// The first of some facets.
std::string first_facets(const std::vector<std::size_t>& facets)
{
    constexpr std::size_t most_shown = 10;
    std::string text;
    for (std::size_t k = 0; k < facets.size() && k < most_shown; ++k)
        text += fmt::format(" {}", facets[k]);
    return text + (facets.size() > most_shown ? " ..." : "");
}

std::string directions_text(const Json& all)
{
    std::string text;
    for (const Json& one : all) {
        const Json& axis = one["axis"];
        text += fmt::format("  direction {}   {:.4g},{:.4g},{:.4g}: {}, ",
                            one["direction"].get<std::size_t>(), axis[0].get<double>(),
                            axis[1].get<double>(), axis[2].get<double>(),
                            counted(one["facets"].get<std::size_t>(), "facet"));
        if (one.contains("refusal"))
            text += "no path: " + one["refusal"].get<std::string>() + "\n";
        else
            text += fmt::format("{}, cut {} mm by contacts, judged {}\n",
                                one["strategy"].get<std::string>(),
                                shown(one["cut_contact_mm"].get<double>()),
                                one["verdict"].get<std::string>());
    }
    return text;
}

std::string indexed_text(const Json& s, const IndexedPlan& plan)
{
    std::string text = fmt::format(
        "  path          {}, cut {} mm by contacts, from {}\n",
        counted(s["path"]["points"].get<std::size_t>(), "point"),
        shown(s["cut_contact_mm"].get<double>()), counted(plan.cuts.size(), "direction"));
    text += directions_text(s["directions"]);
    if (!plan.uncovered.empty())
        text += fmt::format("  uncovered     {}:{}\n",
                            counted(plan.uncovered.size(), "facet"),
                            first_facets(plan.uncovered));
    return text;
}

}  // namespace

PlanResult write_setups_plan(const PlanTask& task, const TriangleMesh& mesh,
                             OutputFolder& folder)
{
    const PlanOptions& options = task.options;
    replace_earlier_plans(folder);
    IndexedOptions indexed = indexed_options(
        task, read_setup_directions(options.setups, options.common.limits));
    ProgressLine progress{"planning", options.common};
    indexed.progress = progress.shower();
    IndexedPlan plan = plan_indexed(mesh, task.context.ball(), indexed);
    if (plan.path.points.empty())
        throw GeometryError{
            plan.cuts.empty()
                ? "no facet is seen from the setups of " + printable(options.setups)
                : "no setup has a path; the first one: " + plan.cuts.front().refusal};
    number_points(plan.path);
    Json summary = indexed_summary(task, plan, indexed);
    add_path_totals(summary["path"], path_totals(plan.path));
    summary["path"]["points"] = plan.path.points.size();
    name_part(summary, options.part, folder.path());
    name_part(summary, {options.setups}, folder.path(), "setup_summary");
    name_cut_facets(summary, task, folder.path());
    const std::string table = tool_path_csv(plan.path);
    identify_path(summary, plan.path.points.size(), content_sha256(table));
    folder.write("toolpath.csv", table);
    folder.write("toolpath.vtp", tool_path_vtp(plan.path));
    FigureOptions figure;
    figure.title = task.context.name + ": contact points in cutting order";
    figure.captions = {fmt::format(
        "{}, scallop height {:g} mm, {}", cutter_word(task.context.cutter),
        options.planning.scallop_height, counted(plan.cuts.size(), "direction"))};
    folder.write("toolpath.svg",
                 tool_path_svg(plan.path, figure, PathDrawing{&task.part, {}}));
    folder.write("summary.json", summary.dump(2) + "\n");
    PlanResult result{summary, indexed_text(summary, plan), 0, {}};
    result.is_undecided = !plan.is_good();
    return result;
}

}  // namespace endmill
