// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/plan_text.h"
#include "cli/progress.h"
#include "cli/surface_facts.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "endmill/files/vtk.h"
#include "endmill/planning/path_memory.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/surface/extent.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// A run with other directions left files that would be taken for this one's.
void replace_earlier_run(OutputFolder& folder)
{
    for (const std::string prefix : {"", "u/", "v/"})
        for (const char* name :
             {"toolpath.csv", "toolpath.vtp", "toolpath.svg", "summary.json"})
            folder.remove_unless_written(prefix + name);
}

// The feed whose digits stand in the program if none is given; nothing else hangs on it.
constexpr double default_feed_mm_per_min = 1000;

// Of the program that `post` writes of this path without options but the feed.
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

// Rays that the part is measured by, about: their pitch follows from its area.
constexpr double measured_rays = 1e5;

// What the path leaves of a block around the part. With another axis than +z, part and
// path are turned.
Deviation measured_deviation(const ToolPath& path, const PlanTask& task)
{
    const auto& [surfaces, context, options] = task;
    const Eigen::Matrix3d rotation = upright_rotation(options.planning.link.axis);
    const Part part =
        turned(Part{std::vector<Surface>(surfaces.begin(), surfaces.end())}, rotation);
    DeviationOptions measure;
    measure.limits = {options.motion.inner,
                      options.planning.scallop_height + options.motion.outer};
    measure.pitch = std::sqrt(area(surfaces) / measured_rays);
    return deviation_in_block(part, turned(path, rotation),
                              Cutter::ball(context.cutter_diameter / 2), measure);
}

struct DirectionResult {
    PlannedDirection planned;
    Json summary;
};

// Plans along one parameter and writes its files into `folder` under `prefix`.
DirectionResult plan_direction(const PlanTask& task, Parameter along,
                               OutputFolder& folder, const std::string& prefix)
{
    const auto& [surfaces, context, options] = task;
    const BallCutter ball{context.cutter_diameter / 2};
    ProgressLine progress{along == Parameter::U ? "planning along u" : "planning along v",
                          options.common};
    IsoParametricOptions planning = options.planning;
    planning.direction = along;
    planning.progress = [&](double share) { progress.show(share); };
    if (options.mode == PlanMode::Verified)
        planning.chord_tolerance = std::min(options.motion.inner, options.motion.outer);
    double points = 0;
    for (const Surface& surface : surfaces)
        points += estimated_points(surface, ball, planning);
    require_path_memory(points, options.common.limits.max_memory_gib);
    VerifiedPlan plan;  // of the paper's, the path
    if (options.mode == PlanMode::Verified) {
        VerifiedOptions verified = verified_options(options, along);
        verified.progress = planning.progress;
        plan = plan_verified(surfaces, ball, verified);
    } else {
        plan.path = plan_iso_parametric(surfaces, ball, planning).path;
    }
    const PlannedDirection planned{along,
                                   path_economy(plan.path),
                                   chord_error(surfaces, plan.path, along),
                                   motion_error(surfaces, plan.path, ball, along),
                                   measured_deviation(plan.path, task),
                                   tape_length(plan.path, task),
                                   plan.lifted_links,
                                   std::move(plan.uncovered)};
    if (!planned.uncovered.empty()) {
        const UncoveredPlace& first = planned.uncovered.front();
        warn(options.common,
             fmt::format("under more than scallop height and outer tolerance, or not "
                         "known to be under less: {}, the first at {} of patch {}",
                         counted(planned.uncovered.size(), "place"),
                         place_text(first.at, first.point), first.patch));
    }
    Json summary = direction_summary(context, options, planned);
    name_part(summary, {options.part}, folder.path() / prefix);
    folder.write(prefix + "toolpath.csv", tool_path_csv(plan.path));
    folder.write(prefix + "toolpath.vtp", tool_path_vtp(plan.path));
    folder.write(prefix + "toolpath.svg",
                 tool_path_svg(plan.path, figure_options(summary)));
    folder.write(prefix + "summary.json", summary.dump(2) + "\n");
    return {planned, std::move(summary)};
}

}  // namespace

PlanResult write_plan(const PlanTask& task, OutputFolder& folder)
{
    replace_earlier_run(folder);
    if (task.options.direction != PlanDirection::Both) {
        const Parameter along =
            task.options.direction == PlanDirection::U ? Parameter::U : Parameter::V;
        DirectionResult result = plan_direction(task, along, folder, "");
        std::string text = direction_text(result.summary);
        return {std::move(result.summary), std::move(text),
                result.planned.uncovered.size()};
    }
    const DirectionResult u = plan_direction(task, Parameter::U, folder, "u/");
    const DirectionResult v = plan_direction(task, Parameter::V, folder, "v/");
    Json summary{{"u", u.summary}, {"v", v.summary}};
    add_comparison(summary, task.options, u.planned, v.planned);
    folder.write("summary.json", summary.dump(2) + "\n");
    return {
        summary,
        direction_text(u.summary) + direction_text(v.summary) + comparison_text(summary),
        u.planned.uncovered.size() + v.planned.uncovered.size()};
}

}  // namespace endmill
