// SPDX-License-Identifier: GPL-3.0-or-later
// endmill plan: from a surface to economic cutter locations.

#include <array>
#include <memory>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/plan_options.h"
#include "cli/plan_summary.h"
#include "cli/progress.h"
#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/io/output_folder.h"
#include "endmill/io/tool_path_csv.h"
#include "endmill/io/tool_path_svg.h"
#include "endmill/io/vtp.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Memory a CL point takes until it is written: the path, and the texts of its files.
constexpr double bytes_per_point = 900;
// The number of points is estimated within about this factor before it is known.
constexpr double estimate_margin = 2;

std::string limit_text(const std::optional<CutterLimit>& limit)
{
    if (!limit)
        return "largest ball: none, the surface has no concavity\n";
    return fmt::format("largest ball: radius {:.6f} mm, at {}\n", limit->radius_mm,
                       place_text(limit->at, limit->point));
}

std::string settings_text(const PlanContext& context, const PlanOptions& options)
{
    return fmt::format(
        "cutter ball:{}, chord tolerance {:g} mm, scallop height {:g} mm, mode paper\n",
        to_text(context.cutter_diameter), options.planning.chord_tolerance,
        options.planning.scallop_height);
}

double chosen_diameter(const std::optional<double>& asked,
                       const std::optional<CutterLimit>& limit)
{
    const auto fits = [&](double diameter) {
        return !limit || diameter / 2 < limit->radius_mm;
    };
    if (asked && !fits(*asked))
        throw GeometryError{fmt::format(
            "--cutter ball:{}: radius {} mm; expected below {:.6f} mm, the largest that "
            "fits, at {}",
            to_text(*asked), to_text(*asked / 2), limit->radius_mm,
            place_text(limit->at, limit->point))};
    if (asked)
        return *asked;
    for (const double diameter : {20, 15, 10, 6, 4, 3, 2, 1})
        if (fits(diameter))
            return diameter;
    throw GeometryError{fmt::format(
        "no ball of 20 to 1 mm diameter fits: the largest has radius {:.6f} mm, at {}; "
        "expected a smaller one, named with --cutter",
        limit->radius_mm, place_text(limit->at, limit->point))};
}

void complete(PlanOptions& options, const Surface& surface, double diameter)
{
    IsoParametricOptions& planning = options.planning;
    planning.chord_tolerance = options.chord_tolerance.value_or(diameter / 30);
    planning.scallop_height = options.scallop_height.value_or(planning.chord_tolerance);
    if (planning.scallop_height >= diameter)
        throw DomainError{"--scallop " + to_text(planning.scallop_height) +
                          ": expected a height below the ball's diameter, " +
                          to_text(diameter) + " mm"};
    planning.link.safe_height =
        options.safe_height.value_or(extent(surface, planning.link.axis).high + 5);
    planning.most_points = static_cast<std::size_t>(options.common.limits.max_memory_gib *
                                                    0x1p30 / bytes_per_point);
}

void require_memory_for(double points, const PlanOptions& options)
{
    const double most = static_cast<double>(options.planning.most_points);
    if (points > estimate_margin * most)
        throw LimitError{fmt::format(
            "about {:.2g} CL points would need about {:.2g} GiB; expected at most {} GiB "
            "(--max-memory), which {:.2g} points fit: larger tolerances make fewer",
            points, points * bytes_per_point / 0x1p30,
            to_text(options.common.limits.max_memory_gib), most)};
}

FigureOptions figure_options(const Json& s)
{
    const std::string direction = s["direction"];
    FigureOptions figure;
    figure.title = s["name"].get<std::string>() +
                   ": contact points in cutting order, along " + direction;
    figure.captions = {fmt::format(
        "TOL = {:g} mm   SCALLOP = {:g} mm   C.D. = {:g} mm   NCL,{} = {}   TCD,{} = "
        "{:.1f} mm",
        s["chord_tolerance_mm"].get<double>(), s["scallop_mm"].get<double>(),
        number_from_text(s["cutter"].get<std::string>().substr(5)).value_or(0), direction,
        s["ncl"].get<std::size_t>(), direction, s["tcd_mm"].get<double>())};
    return figure;
}

// A run with other directions left files that would be taken for this one's.
void replace_earlier_run(OutputFolder& folder)
{
    for (const std::string prefix : {"", "u/", "v/"})
        for (const char* name :
             {"toolpath.csv", "toolpath.vtp", "toolpath.svg", "summary.json"})
            folder.remove_unless_written(prefix + name);
}

struct DirectionResult {
    PlannedDirection planned;
    Json summary;
};

// A surface, what is known of it, and what was asked.
struct PlanTask {
    const Surface& surface;
    const PlanContext& context;
    const PlanOptions& options;
};

// Plans along one parameter and writes its files into `folder` under `prefix`.
DirectionResult plan_direction(const PlanTask& task, Parameter along,
                               OutputFolder& folder, const std::string& prefix)
{
    const auto& [surface, context, options] = task;
    const BallCutter ball{context.cutter_diameter / 2};
    ProgressLine progress{along == Parameter::U ? "planning along u" : "planning along v",
                          options.common};
    IsoParametricOptions planning = options.planning;
    planning.direction = along;
    planning.progress = [&](double share) { progress.show(share); };
    require_memory_for(estimated_points(surface, ball, planning), options);
    const IsoParametricPlan plan = plan_iso_parametric(surface, ball, planning);
    const PlannedDirection planned{along, path_economy(plan.path),
                                   chord_error(surface, plan.path, along)};
    Json summary = direction_summary(context, options, planned);
    folder.write(prefix + "toolpath.csv", tool_path_csv(plan.path));
    folder.write(prefix + "toolpath.vtp", tool_path_vtp(plan.path));
    folder.write(prefix + "toolpath.svg",
                 tool_path_svg(plan.path, figure_options(summary)));
    folder.write(prefix + "summary.json", summary.dump(2) + "\n");
    return {planned, std::move(summary)};
}

// A summary for programs and for a person.
struct PlanResult {
    Json summary;
    std::string text;
};

PlanResult plan_as_asked(const PlanTask& task, OutputFolder& folder)
{
    if (task.options.direction != PlanDirection::Both) {
        const Parameter along =
            task.options.direction == PlanDirection::U ? Parameter::U : Parameter::V;
        Json summary = plan_direction(task, along, folder, "").summary;
        std::string text = direction_text(summary);
        return {std::move(summary), std::move(text)};
    }
    const DirectionResult u = plan_direction(task, Parameter::U, folder, "u/");
    const DirectionResult v = plan_direction(task, Parameter::V, folder, "v/");
    Json summary{{"u", u.summary}, {"v", v.summary}};
    add_comparison(summary, task.options, u.planned, v.planned);
    folder.write("summary.json", summary.dump(2) + "\n");
    return {summary, direction_text(u.summary) + direction_text(v.summary) +
                         comparison_text(summary)};
}

ExitCode run_plan(PlanOptions options)
{
    const SurfaceFile file = read_part(options.part, options.common);
    const Surface& surface = file.surface;
    PlanContext context{file.name, file.source, continuity(surface), {}, 0};
    if (context.continuity.continuity != Continuity::G1) {
        if (options.g1_is_required)
            return refuse_break(options.part, context.continuity, options.common);
        warn(options.common, options.part + ": " + break_text(context.continuity));
    }
    const Vec3& axis = options.planning.link.axis;
    const double side = tool_side_sign(surface, axis);
    require_reachable(surface, axis, side);
    context.limit = largest_cutter(surface, side);
    context.cutter_diameter = chosen_diameter(options.cutter_diameter, context.limit);
    complete(options, surface, context.cutter_diameter);

    OutputFolder folder{output_folder(options.part, "plan", options.common),
                        options.common.force};
    folder.protect(options.part);
    replace_earlier_run(folder);
    const PlanResult result = plan_as_asked({surface, context, options}, folder);
    folder.publish();
    print_result(options.common, result.summary,
                 limit_text(context.limit) + settings_text(context, options) +
                     result.text + "written to " + folder.path().string() + "\n");
    return ExitCode::Yes;
}

}  // namespace

void add_plan_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "plan", "economic cutter locations along the parameters of a surface");
    const auto options = std::make_shared<PlanOptions>();
    add_plan_options(*command, *options);
    command->footer(
        "Writes toolpath.csv, toolpath.vtp, toolpath.svg and summary.json to --output\n"
        "(default ./NAME-plan), for both directions to its folders u and v. With "
        "--force, "
        "files\nof these names that an earlier run left there are replaced or "
        "removed.\n\n"
        "Example:\n  endmill plan datasets/surfaces/net_rot24_7D.json --cutter ball:15 "
        "\\\n      --chord-tolerance 0.5 --scallop 0.5 --direction both -o results");
    command->callback([options, &action] {
        action = [options] {
            try {
                return run_plan(*options);
            } catch (const GeometryError& error) {
                throw GeometryError{options->part + ": " + error.what()};
            }
        };
    });
}

}  // namespace endmill
