// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/plan_text.h"
#include "cli/progress.h"
#include "cli/surface_facts.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "endmill/files/vtk.h"
#include "endmill/planning/path_memory.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/surface/extent.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Removes the files of an earlier run with other directions, which could be mistaken for
// files of this run.
void replace_earlier_run(OutputFolder& folder)
{
    for (const std::string prefix : {"", "u/", "v/"})
        for (const char* name :
             {"toolpath.csv", "toolpath.vtp", "toolpath.svg", "summary.json"})
            folder.remove_unless_written(prefix + name);
}

// The feed in the program if no feed is given. It affects only the length of the tape.
constexpr double default_feed_mm_per_min = 1000;

// Tape length of the program that `post` writes of this path with the default options.
std::optional<double> tape_length(const ToolPath& path, const PlanTask& task)
{
    const auto& [surfaces, context, options] = task;
    if (options.planning.link.axis != Vec3::UnitZ())
        return std::nullopt;
    GcodeOptions program;
    program.name = context.name;
    program.cutter = Cutter::ball(context.cutter_diameter / 2);
    program.feed_mm_per_min = options.feed_mm_per_min.value_or(default_feed_mm_per_min);
    program.tolerance = std::min(
        {options.planning.chord_tolerance, options.motion.inner, options.motion.outer});
    return gcode(path, program).tape_length_m();
}

// Approximate number of measuring rays. Their pitch follows from the area of the part.
constexpr double measured_rays = 1e5;
// Approximate number of measuring rays where the planner has proved the tolerances.
// Fewer rays suffice there, since the proof also covers the surface between them.
constexpr double measured_rays_of_proved = 3e4;

// Whether the planner has proved that the path keeps its tolerances everywhere.
bool is_proved(const VerifiedPlan& plan, const PlanOptions& options)
{
    return options.mode == PlanMode::Verified && plan.uncovered.empty();
}

// Deviation of the part after the path has cut a block around it. If the tool axis is not
// +z, part and path are rotated first.
Deviation measured_deviation(const VerifiedPlan& plan, const PlanTask& task,
                             const std::function<void(double)>& progress)
{
    const auto& [surfaces, context, options] = task;
    const bool proved = is_proved(plan, options);
    const Eigen::Matrix3d rotation = upright_rotation(options.planning.link.axis);
    const Part part =
        turned(Part{std::vector<Surface>(surfaces.begin(), surfaces.end())}, rotation);
    DeviationOptions measure;
    measure.limits = {options.motion.inner,
                      options.planning.scallop_height + options.motion.outer};
    measure.pitch =
        std::sqrt(area(surfaces) / (proved ? measured_rays_of_proved : measured_rays));
    measure.progress = progress;
    if (proved)
        measure.max_refine = 0;
    Deviation found =
        deviation_in_block(part, turned(plan.path, rotation),
                           Cutter::ball(context.cutter_diameter / 2), measure);
    if (proved) {
        const auto tighten = [](double& bound, double limit, double greatest) {
            bound = std::min(bound, std::max(0.0, limit - greatest));
        };
        tighten(found.gouge_bound_mm, measure.limits.tolerance, found.max_gouge_mm);
        tighten(found.scallop_bound_mm, measure.limits.scallop, found.max_scallop_mm);
    }
    return found;
}

std::string direction_word(Parameter along)
{
    return along == Parameter::U ? "u" : "v";
}

// The state of each direction; both may be planned at the same time.
class PlanProgress {
public:
    explicit PlanProgress(const CommonOptions& options) : line_{"planning", options} {}

    // A callback for the work on one direction. It takes the share that is done.
    std::function<void(double)> of(Parameter along, const std::string& work)
    {
        return [this, along, work](double share) {
            const std::lock_guard lock{mutex_};
            states_[along] = fmt::format("along {} {} {:.0f} %", direction_word(along),
                                         work, 100 * share);
            std::string text;
            for (const auto& [parameter, state] : states_)
                text += (text.empty() ? "" : "; ") + state;
            line_.show(text);
        };
    }

private:
    ProgressLine line_;
    std::mutex mutex_;
    std::map<Parameter, std::string> states_;
};

// The options of the planner for one parameter.
IsoParametricOptions planning_options(const PlanTask& task, Parameter along)
{
    const PlanOptions& options = task.options;
    IsoParametricOptions planning = options.planning;
    planning.direction = along;
    if (options.mode == PlanMode::Verified)
        planning.chord_tolerance = std::min(options.motion.inner, options.motion.outer);
    return planning;
}

double points_along(const PlanTask& task, Parameter along)
{
    const BallCutter ball{task.context.cutter_diameter / 2};
    double points = 0;
    for (const Surface& surface : task.surfaces)
        points += estimated_points(surface, ball, planning_options(task, along));
    return points;
}

// Plans the path with the planner of the mode. The planner of mode paper proves nothing.
VerifiedPlan planned_path(const PlanTask& task, Parameter along, PlanProgress& progress)
{
    const BallCutter ball{task.context.cutter_diameter / 2};
    const auto report = progress.of(along, "passes");
    if (task.options.mode == PlanMode::Verified) {
        VerifiedOptions verified = verified_options(task.options, along);
        verified.progress = report;
        return plan_verified(task.surfaces, ball, verified);
    }
    IsoParametricOptions planning = planning_options(task, along);
    planning.progress = report;
    VerifiedPlan plan;
    plan.path = plan_iso_parametric(task.surfaces, ball, planning).path;
    return plan;
}

// A direction and its path.
struct DirectionPlan {
    PlannedDirection planned;
    ToolPath path;
};

DirectionPlan plan_direction(const PlanTask& task, Parameter along,
                             PlanProgress& progress)
{
    const BallCutter ball{task.context.cutter_diameter / 2};
    VerifiedPlan plan = planned_path(task, along, progress);
    const auto report = progress.of(along, "measured");
    report(0);
    PlannedDirection planned{along,
                             path_economy(plan.path),
                             chord_error(task.surfaces, plan.path, along),
                             motion_error(task.surfaces, plan.path, ball, along),
                             measured_deviation(plan, task, report),
                             tape_length(plan.path, task),
                             plan.lifted_links,
                             std::move(plan.uncovered)};
    return {std::move(planned), std::move(plan.path)};
}

void warn_of_uncovered(const PlannedDirection& planned, const CommonOptions& options)
{
    if (planned.uncovered.empty())
        return;
    const UncoveredPlace& first = planned.uncovered.front();
    warn(options,
         fmt::format("along {}: the remaining stock may exceed scallop height and outer "
                     "tolerance at {}; the first is at {} of patch {}",
                     direction_word(planned.along),
                     counted(planned.uncovered.size(), "place"),
                     place_text(first.at, first.point), first.patch));
}

struct DirectionResult {
    PlannedDirection planned;
    Json summary;
};

// Writes the files of one direction into `folder` under `prefix`.
DirectionResult write_direction(const PlanTask& task, DirectionPlan plan,
                                OutputFolder& folder, const std::string& prefix)
{
    const auto& [surfaces, context, options] = task;
    warn_of_uncovered(plan.planned, options.common);
    Json summary = direction_summary(context, options, plan.planned);
    name_part(summary, {options.part}, folder.path() / prefix);
    folder.write(prefix + "toolpath.csv", tool_path_csv(plan.path));
    folder.write(prefix + "toolpath.vtp", tool_path_vtp(plan.path));
    folder.write(prefix + "toolpath.svg",
                 tool_path_svg(plan.path, figure_options(summary)));
    folder.write(prefix + "summary.json", summary.dump(2) + "\n");
    return {std::move(plan.planned), std::move(summary)};
}

// Share of the memory that both directions may need together to be planned at the same
// time.
constexpr double share_of_both = 0.25;

// Whether the paths along all of `directions` fit into memory at the same time.
// \throws LimitError if a single path does not fit.
bool fit_together(const PlanTask& task, std::span<const Parameter> directions)
{
    const double most_gib = task.options.common.limits.max_memory_gib;
    double points = 0;
    for (const Parameter along : directions) {
        const double own = points_along(task, along);
        require_path_memory(own, most_gib);
        points += own;
    }
    return points <= share_of_both * static_cast<double>(most_path_points(most_gib));
}

// Plans along several parameters at the same time.
std::vector<DirectionPlan> plan_directions(const PlanTask& task,
                                           std::span<const Parameter> directions)
{
    PlanProgress progress{task.options.common};
    std::vector<std::optional<DirectionPlan>> plans(directions.size());
    parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            plans[k] = plan_direction(task, directions[k], progress);
    });
    std::vector<DirectionPlan> finished;
    for (std::optional<DirectionPlan>& plan : plans)
        finished.push_back(std::move(plan).value());
    return finished;
}

// Plans along `directions` and writes the results. Two directions get a folder each.
std::vector<DirectionResult> write_directions(const PlanTask& task,
                                              std::span<const Parameter> directions,
                                              OutputFolder& folder)
{
    const bool is_alone = directions.size() == 1;
    const std::size_t at_once = fit_together(task, directions) ? directions.size() : 1;
    std::vector<DirectionResult> results;
    for (std::size_t first = 0; first < directions.size(); first += at_once)
        for (DirectionPlan& plan :
             plan_directions(task, directions.subspan(first, at_once))) {
            const std::string prefix =
                is_alone ? "" : direction_word(plan.planned.along) + "/";
            results.push_back(write_direction(task, std::move(plan), folder, prefix));
        }
    return results;
}

// The deepest gouge of a direction: the larger of the motion error along the passes and
// the deviation measured on the whole part.
double deepest_gouge(const PlannedDirection& planned)
{
    return std::max(planned.deviation.max_gouge_mm,
                    planned.motion_error.gouge.greatest_mm);
}

std::optional<KnownGouge> known_gouge(std::span<const DirectionResult> results,
                                      double tolerance)
{
    std::optional<KnownGouge> deepest;
    for (const DirectionResult& result : results) {
        const double depth = deepest_gouge(result.planned);
        if (depth > tolerance + verdict_slack && (!deepest || depth > deepest->depth_mm))
            deepest = {result.planned.along, depth};
    }
    return deepest;
}

}  // namespace

PlanResult write_plan(const PlanTask& task, OutputFolder& folder)
{
    replace_earlier_run(folder);
    std::vector<Parameter> directions{Parameter::U, Parameter::V};
    if (task.options.direction != PlanDirection::Both)
        directions = {task.options.direction == PlanDirection::U ? Parameter::U
                                                                 : Parameter::V};
    const std::vector<DirectionResult> results =
        write_directions(task, directions, folder);
    PlanResult plan{
        results.front().summary, {}, 0, known_gouge(results, task.options.motion.inner)};
    for (const DirectionResult& result : results) {
        plan.text += direction_text(result.summary);
        plan.uncovered_places += result.planned.uncovered.size();
    }
    if (results.size() == 1)
        return plan;
    plan.summary = {{"u", results[0].summary}, {"v", results[1].summary}};
    add_comparison(plan.summary, task.options, results[0].planned, results[1].planned);
    folder.write("summary.json", plan.summary.dump(2) + "\n");
    plan.text += comparison_text(plan.summary);
    return plan;
}

}  // namespace endmill
