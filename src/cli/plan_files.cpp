// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_files.h"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/plan_text.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/files/path_file.h"
#include "endmill/files/vtk.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// The feed in the program if no feed is given. It affects only the length of the tape.
constexpr double default_feed_mm_per_min = 1000;

// Tape length of the plain program of this path: one feed, no tool length, no dwell.
std::optional<double> tape_length(const ToolPath& path, const PlanTask& task)
{
    const auto& [part, surfaces, context, options, guard, frame, skipped, in_mesh] = task;
    if (options.planning.link.axis != Vec3::UnitZ())
        return std::nullopt;
    GcodeOptions program;
    program.name = context.name;
    program.cutter = context.cutter;
    program.feed_mm_per_min = options.feed_mm_per_min.value_or(default_feed_mm_per_min);
    program.tolerance = std::min(
        {options.planning.chord_tolerance, options.motion.inner, options.motion.outer});
    return gcode(path, program).tape_length_m();
}

std::string direction_word(Parameter along)
{
    return along == Parameter::U ? "u" : "v";
}

// The parts of the work on one direction, in order.
enum class PlanWork { Passes, Measuring };

// The state of each direction; both may be planned at the same time.
class PlanProgress {
public:
    PlanProgress(const CommonOptions& options, std::size_t directions)
        : directions_{directions},
          line_{"planning", options}
    {
    }

    // A callback for the work on one direction. It takes the share that is done.
    std::function<void(double)> of(Parameter along, PlanWork work)
    {
        return [this, along, work](double share) {
            const std::lock_guard lock{mutex_};
            const bool is_first = work == PlanWork::Passes;
            states_[along] = {fmt::format("along {} {} {:.0f} %", direction_word(along),
                                          is_first ? "passes" : "measured", 100 * share),
                              ((is_first ? 0 : 1) + share) / 2};
            std::string text;
            double done = 0;
            for (const auto& [parameter, state] : states_) {
                text += (text.empty() ? "" : "; ") + state.text;
                done += state.share / static_cast<double>(directions_);
            }
            line_.show(text, done);
        };
    }

private:
    struct State {
        std::string text;
        double share;  // of both parts together; they take similar times
    };

    std::size_t directions_;
    ProgressLine line_;
    std::mutex mutex_;
    std::map<Parameter, State> states_;
};

// A direction and its path.
struct MeasuredPath {
    PlannedDirection planned;
    ToolPath path;
};

MeasuredPath plan_direction(const PlanTask& task, Parameter along, PlanProgress& progress)
{
    const auto& [part, surfaces, context, options, guard, frame, skipped, in_mesh] = task;
    const BallCutter ball = context.ball();
    PlannerOptions planner = planner_options(options, along);
    std::visit([&](auto& own) { own.progress = progress.of(along, PlanWork::Passes); },
               planner);
    PlannedPath plan = plan_path(surfaces, ball, planner);
    const auto report = progress.of(along, PlanWork::Measuring);
    report(0);
    const LimitProof proof = plan.is_proved() ? LimitProof::Proved : LimitProof::None;
    const DeviationLimits limits{std::max(options.motion.inner, no_gouge_tolerance),
                                 options.planning.scallop_height + options.motion.outer};
    PlannedDirection planned{
        along,
        path_economy(plan.path),
        chord_error(surfaces, plan.path, along),
        motion_error(surfaces, plan.path, ball, along),
        deviation_of_path(std::vector<Surface>(surfaces.begin(), surfaces.end()),
                          plan.path, Cutter::ball(ball.radius()),
                          {limits, proof, report}),
        tape_length(plan.path, task),
        {},
        plan.lifted_links,
        std::move(plan.uncovered).value_or(std::vector<UncoveredPlace>{})};
    planned.missed =
        missed_limits(planned.errors(),
                      {options.planning.chord_tolerance * (1 + limit_rounding),
                       limits.tolerance + verdict_slack, limits.scallop + verdict_slack});
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
DirectionResult write_direction(const PlanTask& task, MeasuredPath plan,
                                OutputFolder& folder, const std::string& prefix)
{
    const auto& [part, surfaces, context, options, guard, frame, skipped, in_mesh] = task;
    warn_of_uncovered(plan.planned, options.common);
    number_points(plan.path);
    Json summary = direction_summary(context, options, plan.planned);
    add_path_totals(summary["path"], path_totals(plan.path));
    summary["path"]["points"] = plan.path.points.size();
    name_part(summary, options.part, folder.path() / prefix);
    const std::string table = tool_path_csv(plan.path);
    identify_path(summary, plan.path.points.size(), content_sha256(table));
    folder.write(prefix + "toolpath.csv", table);
    folder.write(prefix + "toolpath.vtp", tool_path_vtp(plan.path));
    folder.write(prefix + "toolpath.svg",
                 tool_path_svg(plan.path, figure_options(summary), surfaces));
    folder.write(prefix + "summary.json", summary.dump(2) + "\n");
    return {std::move(plan.planned), std::move(summary)};
}

// Whether the paths along all of `directions` fit into memory at the same time.
// \throws LimitError if a single path does not fit.
bool can_plan_together(const PlanTask& task, std::span<const Parameter> directions)
{
    const BallCutter ball = task.context.ball();
    std::vector<double> points;
    for (const Parameter along : directions)
        points.push_back(
            estimated_points(task.surfaces, ball, planner_options(task.options, along)));
    return fit_together(points, task.options.common.limits.max_memory_gib);
}

// Plans along several parameters at the same time.
std::vector<MeasuredPath> plan_directions(const PlanTask& task,
                                          std::span<const Parameter> directions)
{
    PlanProgress progress{task.options.common, directions.size()};
    std::vector<std::optional<MeasuredPath>> plans(directions.size());
    parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            plans[k] = plan_direction(task, directions[k], progress);
    });
    std::vector<MeasuredPath> finished;
    finished.reserve(plans.size());
    for (std::optional<MeasuredPath>& plan : plans)
        finished.push_back(std::move(plan).value());
    return finished;
}

// Plans along `directions` and writes the results. Two directions get a folder each.
std::vector<DirectionResult> write_directions(const PlanTask& task,
                                              std::span<const Parameter> directions,
                                              OutputFolder& folder)
{
    const bool is_alone = directions.size() == 1;
    const std::size_t at_once =
        can_plan_together(task, directions) ? directions.size() : 1;
    std::vector<DirectionResult> results;
    for (std::size_t first = 0; first < directions.size(); first += at_once)
        for (MeasuredPath& plan :
             plan_directions(task, directions.subspan(first, at_once))) {
            const std::string prefix =
                is_alone ? "" : direction_word(plan.planned.along) + "/";
            results.push_back(write_direction(task, std::move(plan), folder, prefix));
        }
    return results;
}

std::optional<KnownGouge> known_gouge(std::span<const DirectionResult> results)
{
    std::optional<KnownGouge> deepest;
    for (const auto& [planned, summary] : results) {
        const double depth = planned.errors().gouge;
        if (planned.missed.contains(PathLimit::Gouge) &&
            (!deepest || depth > deepest->depth_mm))
            deepest = {planned.along, depth};
    }
    return deepest;
}

}  // namespace

void name_cut_facets(Json& summary, const PlanTask& task,
                     const std::filesystem::path& folder)
{
    const PlanOptions& options = task.options;
    if (options.skip_facets.empty() && options.faces.empty())
        return;
    if (!options.skip_facets.empty())
        name_part(summary, {options.skip_facets}, folder, "skip_facets");
    if (!options.faces.empty())
        summary["cut_faces"] = options.faces;
    summary["skipped"] = task.skipped.size();
    summary["part_sha256"] =
        content_sha256(read_file(options.part.path, options.common.limits));
}

void replace_earlier_plans(OutputFolder& folder)
{
    for (const std::string prefix : {"", "u/", "v/"})
        for (const char* name :
             {"toolpath.csv", "toolpath.vtp", "toolpath.svg", "summary.json"})
            folder.remove_unless_written(prefix + name);
    for (const char* name : {"angles.csv", "angles.svg", "density.svg"})
        folder.remove_unless_written(name);
}

PlanResult write_plan(const PlanTask& task, OutputFolder& folder)
{
    replace_earlier_plans(folder);
    std::vector<Parameter> directions{Parameter::U, Parameter::V};
    if (task.options.direction != PlanDirection::Both)
        directions = {task.options.direction == PlanDirection::U ? Parameter::U
                                                                 : Parameter::V};
    const std::vector<DirectionResult> results =
        write_directions(task, directions, folder);
    PlanResult plan{results.front().summary, {}, 0, known_gouge(results)};
    std::vector<std::string> missed;
    for (const auto& [planned, summary] : results) {
        if (!planned.missed.empty())
            missed.push_back(missed_text(planned));
        plan.text += direction_text(planned, summary);
        plan.uncovered_places += planned.uncovered.size();
    }
    if (results.size() == 2) {
        plan.summary = {{"u", results[0].summary}, {"v", results[1].summary}};
        add_comparison(plan.summary, task.options, results[0].planned,
                       results[1].planned);
        folder.write("summary.json", plan.summary.dump(2) + "\n");
        plan.text += comparison_text(plan.summary);
    }
    if (task.options.mode == Planner::Paper)
        plan.text += better_mode_text(missed);
    return plan;
}

}  // namespace endmill
