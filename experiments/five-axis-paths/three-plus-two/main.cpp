// SPDX-License-Identifier: GPL-3.0-or-later
// 3+2 axes against a tool that turns all the time: the same part, ball and scallop.
//
//   five-axis-paths-three-plus-two OUTPUT_FOLDER
//
// Deterministic, under a minute. Columns and verdicts: README.md beside this.

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/orientation/indexed_plan.h"
#include "endmill/orientation/oriented_path.h"
#include "endmill/post/machine_path.h"
#include "endmill/setup/path_setup.h"
#include "endmill/setup/several_setups.h"
#include "endmill/verification/verification.h"
#include "support/experiment.h"
#include "support/height_block.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

// Both methods on one part.
class Study {
public:
    Study(Experiment& run, CsvTable& result, std::string name,
          const std::function<double(double x, double y)>& height)
        : run_{run},
          result_{result},
          name_{std::move(name)},
          block_{height_block(run.number("half_side_mm"), run.number("bottom_mm"),
                              static_cast<int>(run.number("squares")), height)},
          ball_{Cutter::ball(run.number("radius_mm"))}
    {
    }

    // From the directions that together see the top, each facet within an angle of its normal.
    void three_plus_two(double incidence_deg)
    {
        StudiedPart part =
            studied_part(block_.mesh, "hex:10", Angle::degrees(incidence_deg));
        VisibilityMap& map = part.visibility.map;
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            for (const std::size_t facet : block_.others)
                map.column(cell)[facet / 64] &= ~(std::uint64_t{1} << facet % 64);
        const SetupCover cover = greedy_setups(map, part.grid.centres,
                                               {configuration_from_word("W/xyBz/T")}, 8);
        IndexedOptions options;
        for (const PartialSetup& setup : cover.setups)
            options.directions.push_back(setup.pose.tool_axis);
        options.skipped = block_.others;
        options.strategy = Strategy::Planar;
        options.scallop_height = run_.number("scallop_mm");
        options.inner_tolerance = run_.number("inner_tolerance_mm");
        const IndexedPlan plan =
            plan_indexed(block_.mesh, BallCutter{ball_.radius()}, options);
        add_rows("3+2 within " + to_text(incidence_deg), plan.cuts.size(), plan.path);
    }

    // With an axis field on planar passes.
    void continuous()
    {
        OrientedOptions options;
        options.mode = AxisMode::Field;
        options.scallop_height = run_.number("scallop_mm");
        options.inner_tolerance = run_.number("inner_tolerance_mm");
        options.safe_height = 20;
        options.mesh_passes.strategy = Strategy::Planar;
        options.mesh_passes.skipped_facets = block_.others;
        add_rows("continuous", 0,
                 plan_judged_oriented(block_.mesh, ball_, options).plan.path);
    }

private:
    // The verdict by simulated removal with the turning axis.
    std::string judged(const ToolPath& path) const
    {
        const Part part = block_.mesh;
        VerificationTask task{.path = &path,
                              .cutter = ball_,
                              .stock = default_block(&part, path, ball_),
                              .resolution = run_.number("resolution_mm"),
                              .engine = RemovalEngine::FiveAxis};
        const double tolerance = run_.number("inner_tolerance_mm");
        task.judged = JudgedPart{.part = &part,
                                 .limits = {tolerance, run_.number("scallop_mm")},
                                 .skipped_facets = block_.others};
        return std::string{verdict_name(verify_path(task).verdict)};
    }

    // Feeds of all moves, so that the time of rapids counts too.
    ToolPath with_feeds(ToolPath path) const
    {
        for (PathPoint& point : path.points) {
            const bool is_rapid = point.move == Move::Rapid;
            point.conditions.feed_mm_per_min =
                run_.number(is_rapid ? "rapid_mm_per_min" : "feed_mm_per_min");
            if (is_rapid)
                point.move = Move::Link;
        }
        return path;
    }

    void add_rows(const std::string& method, std::size_t setups, const ToolPath& planned)
    {
        const PathTotals totals = path_totals(planned);
        const std::string verdict = judged(planned);
        const ToolPath path = with_feeds(planned);
        for (const std::string kind : {"ca-table-table", "cb-head-head"}) {
            const Machine machine =
                moving_machine(read_machine("datasets/machines/" + kind + ".json"));
            const MachinePathReport fast =
                report(path, machine, run_.number("rotary_rate_deg_per_min"));
            const MachinePathReport slow =
                report(path, machine, run_.number("slow_rotary_rate_deg_per_min"));
            result_.add_row(
                {name_ + ", " + method + ", " + kind, name_, method, kind,
                 static_cast<std::int64_t>(setups),
                 static_cast<std::int64_t>(path.points.size()), totals.cut_mm,
                 totals.cut_mm + totals.plunge_mm + totals.link_mm + totals.rapid_mm,
                 Angle::radians(fast.rotary_travel).degrees(), fast.time_min,
                 slow.time_min, verdict});
        }
    }

    // The motions on a machine with this largest speed of its rotary axes.
    MachinePathReport report(const ToolPath& path, Machine machine,
                             double deg_per_min) const
    {
        const double rate = Angle::degrees(deg_per_min).radians();
        machine.rates.rotary_rad_per_min = {rate, rate};
        return path_setup(path, machine, {.cutter = ball_}).motions.report;
    }

    Experiment& run_;
    CsvTable& result_;
    std::string name_;
    HeightBlock block_;
    Cutter ball_;
};

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-paths/three-plus-two";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        CsvTable result{{"row", "part", "method", "machine", "setups", "points", "cut_mm",
                         "path_mm", "rotary_travel_deg", "time_min", "slow_time_min",
                         "verdict"}};
        const double half = run.number("half_side_mm");
        const double width = run.number("bump_width_mm");
        const double bump = run.number("bump_mm");
        const double rise = run.number("saddle_mm");
        const double wall = run.number("wall_mm");
        const auto bump_height = [&](double x, double y) {
            return bump * std::exp(-(x * x + y * y) / (width * width));
        };
        const auto saddle_height = [&](double x, double y) {
            return rise * (x * x - y * y) / (half * half) + wall * std::pow(y / half, 4);
        };
        for (Study study : {Study{run, result, "bump", bump_height},
                            Study{run, result, "saddle with walls", saddle_height}}) {
            for (const double incidence_deg : run.numbers("incidences_deg"))
                study.three_plus_two(incidence_deg);
            study.continuous();
        }
        run.write_result(result);
    });
}
