// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/path_setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/post/machine_path.h"
#include "endmill/setup/detail/sampled_poses.h"
#include "endmill/setup/setup_travel.h"
#include "endmill/visibility/sphere_grid.h"

// The search for poses is that of `setup`. Each tool axis of the path takes the place of a
// facet, whose cone is this one direction.

namespace endmill {
namespace {

// Tool axes of a path that are all searched for. A path of 3+2 axes has fewer.
constexpr std::size_t most_axes = 400;
// Side of the cubes in which one tool axis represents the others: about one degree.
constexpr double cube_side = 0.0175;
// mm by which X, Y and Z must stay within their limits: rapids may deviate by as much.
constexpr double least_slack = 0.1;
constexpr std::size_t most_poses = 500;
// Rotations that are tried together. It does not depend on the number of threads.
constexpr std::size_t batch = 8;

// A tool axis of a path.
struct PathAxis {
    Vec3 axis;        // unit
    std::size_t row;  // index of the first point that has it
};

// The different tool axes of a path, in its order.
std::vector<PathAxis> axes_of_path(const ToolPath& path)
{
    std::set<std::array<double, 3>> known;
    std::vector<PathAxis> axes;
    for (std::size_t row = 0; row < path.points.size(); ++row) {
        const Vec3& axis = path.points[row].location.axis;
        if (known.insert({axis.x(), axis.y(), axis.z()}).second)
            axes.push_back({axis, row});
    }
    return axes;
}

// The tool axes that are searched for: all, or if they are many, the first in each cube of a
// lattice.
std::vector<PathAxis> searched_axes(const std::vector<PathAxis>& axes)
{
    if (axes.size() <= most_axes)
        return axes;
    std::set<std::array<int, 3>> cubes;
    std::vector<PathAxis> kept;
    for (const PathAxis& axis : axes) {
        const Vec3 cube = (axis.axis / cube_side).array().floor();
        if (cubes
                .insert({static_cast<int>(cube.x()), static_cast<int>(cube.y()),
                         static_cast<int>(cube.z())})
                .second)
            kept.push_back(axis);
    }
    return kept;
}

// Directions of tool axes, which come first, and of the cells of a sphere.
SphereGrid directions(const std::vector<PathAxis>& axes)
{
    SphereGrid grid;
    for (const PathAxis& axis : axes)
        grid.centres.push_back(axis.axis);
    const std::vector<Vec3> cells = sphere_grid("hex:10").centres;
    grid.centres.insert(grid.centres.end(), cells.begin(), cells.end());
    return grid;
}

// Rotations of the part with which the first axes are within the rotary limits.
std::vector<FittedPose> poses_for(const SphereGrid& grid, std::size_t axes,
                                  const Machine& machine)
{
    PartVisibility visibility{VisibilityMap{axes, grid.centres.size()}, {}};
    for (std::size_t k = 0; k < axes; ++k)
        visibility.map.column(k)[k / 64] |= std::uint64_t{1} << k % 64;
    return sampled_poses(
        grid, visibility,
        {{.configuration = machine.configuration, .limits = machine.rotary},
         SetupMode::Corrected,
         PoseMeasure{*machine.configuration.family, SetupObjective::TotalRange}});
}

[[noreturn]] void refuse_axes(const SphereGrid& grid, const std::vector<PathAxis>& axes,
                              const Machine& machine)
{
    std::size_t reached = 0;
    std::size_t missed = axes.size();
    while (missed - reached > 1) {
        const std::size_t middle = (reached + missed) / 2;
        (poses_for(grid, middle, machine).empty() ? missed : reached) = middle;
    }
    const PathAxis& first = axes[missed - 1];
    throw GeometryError{"point " + std::to_string(first.row) +
                        " of the path: no rotation of the part brings its tool axis " +
                        to_text(first.axis.x()) + ", " + to_text(first.axis.y()) + ", " +
                        to_text(first.axis.z()) +
                        " and those before it within the limits of the rotary axes of " +
                        machine.configuration.word +
                        "; expected wider limits, another machine, or a plan with fewer "
                        "setups"};
}

// A rotation of the part on the machine, and how far the path gets there.
struct Trial {
    std::variant<MachinePath, BlockedPoint> motions;
    std::optional<ClampingFit> clamping;  // set if the rotary axes follow the path
};

class TrialRun {
public:
    TrialRun(const ToolPath& path, const Machine& machine,
             const PathSetupOptions& options)
        : path_{path},
          machine_{machine},
          options_{options}
    {
        moving_.cutter = options.cutter;
        moving_.free_height = free_height(path);
    }

    Trial at(const SetupPose& pose) const
    {
        const PartOnMachine setup{machine_, options_.tool_length,
                                  part_to_machine(pose, machine_.configuration),
                                  Vec3::Zero()};
        Trial trial{machine_motions(path_, setup, moving_), {}};
        if (auto* made = std::get_if<MachinePath>(&trial.motions)) {
            const std::vector<ClampingBound> bounds =
                clamping_bounds(machine_, made->path.machine->positions);
            trial.clamping = options_.clamp ? clamping_fit(bounds, *options_.clamp)
                                            : best_clamping(bounds, Vec3::Zero());
        }
        return trial;
    }

    // The motions in a setup whose rotary axes follow the path.
    MachinePath motions_in(const PartOnMachine& setup) const
    {
        return machine_path(path_, setup, moving_);
    }

    bool fits(const Trial& trial) const
    {
        return trial.clamping &&
               (options_.clamp ? trial.clamping->is_within()
                               : trial.clamping->least_slack() >= least_slack);
    }

private:
    const ToolPath& path_;
    const Machine& machine_;
    const PathSetupOptions& options_;
    MachinePathOptions moving_;
};

// Whether a trial gets farther than another one: within the rotary limits with less excess
// of X, Y and Z, or else to a later point.
bool is_better(const Trial& trial, const Trial& other)
{
    if (trial.clamping && other.clamping)
        return trial.clamping->least_slack() > other.clamping->least_slack();
    if (trial.clamping || other.clamping)
        return trial.clamping.has_value();
    return std::get<BlockedPoint>(trial.motions).row >
           std::get<BlockedPoint>(other.motions).row;
}

// A number with three decimals.
std::string short_text(double value)
{
    constexpr double steps = 1e3;
    return to_text(std::round(value * steps) / steps);
}

// The message about the best of the rotations that were tried.
[[noreturn]] void refuse(const Trial& best, std::size_t tried, const Machine& machine)
{
    const std::string rotations = counted(tried, "rotation") + " of the part " +
                                  (tried == 1 ? "was" : "were") + " tried";
    if (const auto* blocked = std::get_if<BlockedPoint>(&best.motions)) {
        const char letter = machine.configuration.rotary[blocked->axis].letter;
        throw GeometryError{
            "point " + std::to_string(blocked->row) + " of the path: axis " +
            static_cast<char>(letter - 'a' + 'A') + " at " +
            short_text(Angle::radians(blocked->position).degrees()) +
            " degrees exceeds its limit " +
            short_text(Angle::radians(blocked->limit).degrees()) + "; " + rotations +
            ", and none lets the axes follow the path farther; expected wider limits, or "
            "post with --retract"};
    }
    const auto& made = std::get<MachinePath>(best.motions);
    const auto& positions = made.path.machine->positions;
    std::size_t worst = 0;
    Eigen::Index axis = 0;
    double slack = HUGE_VAL;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const ClampingFit fit =
            clamping_fit(clamping_bounds(machine, std::span{positions}.subspan(i, 1)),
                         best.clamping->clamp);
        if (fit.least_slack() >= slack)
            continue;
        slack = fit.slack.minCoeff(&axis);
        worst = i;
    }
    throw GeometryError{
        "point " + std::to_string(made.rows[worst]) + " of the path: " + "XYZ"[axis] +
        (slack < 0 ? " exceeds its travel by " + short_text(-slack) + " mm"
                   : " stays only " + short_text(slack) + " mm within its travel") +
        " at the best rotation and clamping position; " + rotations +
        "; expected more travel, another clamping position or a shorter tool"};
}

// The part as it stands in the path.
SetupPose pose_of_path(const Machine& machine)
{
    const RotaryFrame frame = machine_frame(machine.configuration);
    return {frame.tool_axis, frame.r1_axis, frame.r2_axis};
}

// Tries rotations in their order, until one fits or there are no more.
class PoseTrials {
public:
    PoseTrials(const TrialRun& run, const PathSetupOptions& options)
        : run_{run},
          options_{options}
    {
    }

    // Whether one of the poses fits. It is then the last of those tried.
    bool find(std::span<const SetupPose> poses)
    {
        const std::size_t all = tried_ + poses.size();
        for (std::size_t first = 0; first < poses.size(); first += batch) {
            const std::size_t count = std::min(batch, poses.size() - first);
            std::vector<std::optional<Trial>> trials(count);
            parallel_for(count, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                    trials[k] = run_.at(poses[first + k]);
            });
            for (std::size_t k = 0; k < count; ++k) {
                ++tried_;
                const bool fits = run_.fits(*trials[k]);
                if (fits || !best_ || is_better(*trials[k], *best_)) {
                    best_ = std::move(trials[k]);
                    pose_ = poses[first + k];
                }
                if (fits)
                    return true;
            }
            if (options_.progress)
                options_.progress(tried_, all);
        }
        return false;
    }

    const SetupPose& pose() const { return pose_; }  // of the best trial
    Trial take_best() { return *std::move(best_); }  // after a trial
    std::size_t tried() const { return tried_; }

private:
    const TrialRun& run_;
    const PathSetupOptions& options_;
    std::optional<Trial> best_;
    SetupPose pose_{};
    std::size_t tried_ = 0;
};

std::vector<SetupPose> poses_to_try(const std::vector<PathAxis>& axes,
                                    const Machine& machine)
{
    const std::vector<PathAxis> searched = searched_axes(axes);
    const SphereGrid grid = directions(searched);
    const std::vector<FittedPose> fits = poses_for(grid, searched.size(), machine);
    if (fits.empty())
        refuse_axes(grid, searched, machine);
    std::vector<SetupPose> poses;
    for (const FittedPose& fit : std::span{fits}.first(std::min(fits.size(), most_poses)))
        poses.push_back(fit.pose);
    return poses;
}

}  // namespace

PathSetup path_setup(const ToolPath& path, const Machine& machine,
                     const PathSetupOptions& options)
{
    require(machine.configuration.family.has_value(),
            "path_setup: need a machine with two rotary axes that tilt the tool");
    require(!path.points.empty(), "path_setup: need a path with points");
    const std::vector<PathAxis> axes = axes_of_path(path);
    const TrialRun run{path, machine, options};
    PoseTrials trials{run, options};
    const bool fits = trials.find(std::array{pose_of_path(machine)}) ||
                      trials.find(poses_to_try(axes, machine));
    const SetupPose pose = trials.pose();
    Trial best = trials.take_best();
    if (!fits)
        refuse(best, trials.tried(), machine);
    const Eigen::Matrix3d rotation = part_to_machine(pose, machine.configuration);
    // The positions at the clamping position that was found.
    const PartOnMachine setup{machine, options.tool_length, rotation,
                              best.clamping->clamp};
    return {pose,        rotation,      *best.clamping, run.motions_in(setup),
            axes.size(), trials.tried()};
}

}  // namespace endmill
