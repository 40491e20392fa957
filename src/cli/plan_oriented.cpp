// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_oriented.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
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
#include "endmill/files/machining_data.h"
#include "endmill/files/path_file.h"
#include "endmill/files/vtk.h"
#include "endmill/orientation/oriented_path.h"
#include "endmill/strategy/strategy.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// A judged path, and the parameter along its passes on surfaces.
struct DirectedPath {
    std::optional<Parameter> along;
    JudgedOrientedPath judged;
};

bool is_clean(const DirectedPath& path)
{
    return path.judged.verification.verdict == Verdict::Clean;
}

// A turn in degrees per mm below which the report shows none: rounding.
constexpr double least_turn = 1e-9;

// What a field knows of tool and machine.
struct FieldSetup {
    std::vector<ToolCylinder> body = {};  // shank and holder
    std::optional<PartOnMachine> machine = {};
};

FieldSetup field_setup(const PlanTask& task, OutputFolder& folder)
{
    const PlanOptions& options = task.options;
    for (const std::string& file : {options.tool, options.rotary.machine, options.setup})
        if (!file.empty())
            folder.protect(file);
    FieldSetup setup;
    double length = 0;
    if (!options.tool.empty()) {
        const Tool tool = read_tool(options.tool, options.common.limits);
        if (tool.cutter != task.context.cutter)
            throw DomainError{"--tool " + options.tool + ": found the cutter " +
                              cutter_word(tool.cutter) + "; expected that of --cutter, " +
                              cutter_word(task.context.cutter)};
        setup.body = tool_body(tool);
        length = tool.length;
    }
    RotaryOptions rotary = options.rotary;
    rotary.setup = options.setup;
    setup.machine = part_on_machine(rotary, length, options.common);
    // The part is planned as it stands on the machine.
    if (setup.machine)
        setup.machine->part_to_machine.setIdentity();
    if (setup.machine && !setup.machine->machine.configuration.is_valid())
        throw DomainError{"--machine " + printable(options.rotary.machine) + ": " +
                          why_not_valid(setup.machine->machine.configuration)};
    return setup;
}

OrientedOptions oriented_options(const PlanTask& task, const FieldSetup& setup)
{
    const PlanOptions& options = task.options;
    OrientedOptions oriented;
    oriented.mode = *options.axis_mode;
    oriented.inclination = options.inclination;
    if (const auto strategy = chosen_strategy(options.strategy))
        oriented.mesh_passes.strategy = *strategy;
    oriented.mesh_passes.direction = options.pass_direction;
    oriented.mesh_passes.skipped_facets = task.skipped_in_mesh;
    oriented.mesh_passes.most_samples =
        most_part_samples(options.common.limits.max_memory_gib);
    oriented.scallop_height = options.planning.scallop_height;
    oriented.inner_tolerance = options.motion.inner;
    oriented.order = options.planning.link.order;
    oriented.safe_height = options.planning.link.safe_height;
    oriented.most_points = options.planning.most_points;
    oriented.field.lead = options.lead_range;
    oriented.field.tilt = options.tilt_range;
    oriented.field.machine = setup.machine ? &*setup.machine : nullptr;
    oriented.tool_body = setup.body;
    return oriented;
}

// The path along the asked parameter; otherwise the shorter clean one of both.
DirectedPath along_parameters(const PlanTask& task, const Part& standing,
                              OrientedOptions options, ProgressLine& progress)
{
    const PlanDirection direction = task.options.direction;
    std::vector<Parameter> parameters{Parameter::U, Parameter::V};
    if (direction != PlanDirection::Both)
        parameters = {direction == PlanDirection::U ? Parameter::U : Parameter::V};
    std::optional<DirectedPath> best;
    for (const Parameter along : parameters) {
        progress.begin(
            fmt::format("planning along {}", along == Parameter::U ? "u" : "v"),
            along == parameters.back() ? 0 : 1);
        options.along = along;
        options.progress = progress.shower();
        DirectedPath path{along,
                          plan_judged_oriented(standing, task.context.cutter, options)};
        const bool is_better =
            !best || (is_clean(path) && !is_clean(*best)) ||
            (is_clean(path) == is_clean(*best) &&
             path.judged.plan.cut_contact_mm < best->judged.plan.cut_contact_mm);
        if (is_better)
            best = std::move(path);
    }
    return std::move(*best);
}

// The path, planned for the part as it stands on the machine.
DirectedPath chosen_path(const PlanTask& task, const FieldSetup& setup,
                         ProgressLine& progress)
{
    const bool is_turned = !task.options.setup.empty();
    const Part standing = is_turned ? turned(task.part, task.part_to_machine) : task.part;
    OrientedOptions options = oriented_options(task, setup);
    options.progress = progress.shower();
    DirectedPath path =
        task.context.is_mesh
            ? DirectedPath{{},
                           plan_judged_oriented(standing, task.context.cutter, options)}
            : along_parameters(task, standing, options, progress);
    ToolPath& made = path.judged.plan.path;
    if (is_turned)
        made = turned(made, task.part_to_machine.transpose());
    return path;
}

Json extent_json(const AngleExtent& extent)
{
    return Json::array(
        {extent.least.written_degrees(), extent.greatest.written_degrees()});
}

Json range_json(const LeanRange& range)
{
    return Json::array({range.from.written_degrees(), range.to.written_degrees()});
}

Json summary_of(const PlanTask& task, const DirectedPath& path)
{
    const auto& [plan, verification] = path.judged;
    const PlanOptions& options = task.options;
    const Deviation& deviation = verification.on_part->deviation;
    Json summary{
        {"name", task.context.name},
        {"source", task.context.source},
        {"endmill", program_version},
        {"axis_mode", axis_mode_word(*options.axis_mode)},
        {path.along ? "along" : "strategy",
         path.along ? (*path.along == Parameter::U ? "u" : "v")
                    : strategy_word(options.strategy)},
        {"cutter", cutter_word(task.context.cutter)},
        {"passes", plan.passes},
        {"cut_contact_mm", plan.cut_contact_mm},
        {"lead_range_deg", extent_json(plan.lead)},
        {"tilt_deg", options.inclination.tilt.written_degrees()},
        {"tilt_range_deg", extent_json(plan.tilt)},
        {"rotary_travel_deg", plan.rotary_travel.written_degrees()},
        {"max_turn_deg_per_mm", plan.most_turn_deg_per_mm},
        {"min_gap_mm", plan.least_gap_mm ? Json(*plan.least_gap_mm) : Json(nullptr)},
        {"narrowest_strip_mm", plan.narrowest_strip_mm},
        {"strip_mm", Json::array({plan.narrowest_strip_mm, plan.widest_strip_mm})},
        {"scallop_mm", options.planning.scallop_height},
        {"inner_tolerance_mm", options.motion.inner},
        {"max_gouge_mm", deviation.max_gouge_mm},
        {"gouge_bound_mm", finite_or_null(deviation.gouge_bound_mm)},
        {"max_left_mm", finite_or_null(deviation.max_scallop_mm)},
        {"left_bound_mm", finite_or_null(deviation.scallop_bound_mm)},
        {"verdict", verdict_name(verification.verdict)},
        {"interpolation", "linear"},
        {"safe_height_mm", options.planning.link.safe_height}};
    if (options.axis_mode == AxisMode::Field) {
        summary["asked_lead_range_deg"] = range_json(options.lead_range);
        summary["asked_tilt_range_deg"] = range_json(options.tilt_range);
        if (!options.rotary.machine.empty())
            summary["machine_of_field"] = printable(options.rotary.machine);
    }
    if (path.along)
        add_continuity(summary, task.context.continuity, task.context.several);
    return summary;
}

std::string tilt_text(const Json& range)
{
    const double least = range[0].get<double>();
    const double greatest = range[1].get<double>();
    return least == greatest ? fmt::format("{:.3g}", least)
                             : fmt::format("{:.3g} to {:.3g}", least, greatest);
}

std::string report(const Json& s, const PlanOptions& options)
{
    const auto number = [&](const char* key) { return s[key].get<double>(); };
    return fmt::format(
        "  {:<13} {} passes, {} points; cut {} mm by contacts; lead {:.3g} to "
        "{:.3g} degrees, tilt {}; strips of {} mm and more\n"
        "  axis turns    {} degrees in all, at most {:.3g} degrees per mm on cuts\n"
        "  judged        {}: gouge {} mm (limit {}), remaining {} mm (limit {})\n",
        s.contains("along") ? "along " + s["along"].get<std::string>()
                            : s["strategy"].get<std::string>(),
        s["passes"].get<std::size_t>(), s["path"]["points"].get<std::size_t>(),
        shown(number("cut_contact_mm")), s["lead_range_deg"][0].get<double>(),
        s["lead_range_deg"][1].get<double>(), tilt_text(s["tilt_range_deg"]),
        shown(number("narrowest_strip_mm")), shown_degrees(number("rotary_travel_deg")),
        number("max_turn_deg_per_mm") > least_turn ? number("max_turn_deg_per_mm") : 0.0,
        s["verdict"].get<std::string>(),
        shown_against(number("max_gouge_mm"), options.motion.inner),
        shown_limit(options.motion.inner),
        s["max_left_mm"].is_null()
            ? std::string{"unknown"}
            : shown_against(number("max_left_mm"), options.planning.scallop_height),
        shown_limit(options.planning.scallop_height));
}

}  // namespace

PlanResult write_oriented_plan(const PlanTask& task, OutputFolder& folder)
{
    replace_earlier_plans(folder);
    ProgressLine progress{"planning", task.options.common, 1};
    const FieldSetup setup = field_setup(task, folder);
    const DirectedPath path = chosen_path(task, setup, progress);
    const ToolPath& tool_path = path.judged.plan.path;
    Json summary = summary_of(task, path);
    add_path_totals(summary["path"], path_totals(tool_path));
    summary["path"]["points"] = tool_path.points.size();
    name_part(summary, task.options.part, folder.path());
    if (!task.options.setup.empty())
        name_part(summary, {task.options.setup}, folder.path(), "setup");
    name_cut_facets(summary, task, folder.path());
    const std::string table = tool_path_csv(tool_path);
    identify_path(summary, tool_path.points.size(), content_sha256(table));
    folder.write("toolpath.csv", table);
    folder.write("toolpath.vtp", tool_path_vtp(tool_path));
    FigureOptions figure;
    figure.title =
        fmt::format("{}: contact points in cutting order, axis mode {}",
                    task.context.name, axis_mode_word(*task.options.axis_mode));
    figure.captions = {fmt::format(
        "{}, scallop height {:g} mm, {} points", cutter_word(task.context.cutter),
        task.options.planning.scallop_height, tool_path.points.size())};
    folder.write("toolpath.svg",
                 tool_path_svg(tool_path, figure, PathDrawing{&task.part, {}}));
    folder.write("summary.json", summary.dump(2) + "\n");
    PlanResult result{summary, report(summary, task.options), 0, {}};
    result.is_undecided = !is_clean(path);
    return result;
}

}  // namespace endmill
