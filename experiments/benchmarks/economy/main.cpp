// SPDX-License-Identifier: GPL-3.0-or-later
// Time and length of covering paths, with the bars, beside parallel planes at a fixed pitch.
//
//   benchmarks-economy OUTPUT_FOLDER
//
// About three minutes; measures time, so nothing else should run. Columns: README.md beside
// this.

#include <array>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/economy/parallel_planes.h"
#include "benchmarks/height_parts.h"
#include "endmill/bound/path_bound.h"
#include "endmill/core/parallel.h"
#include "endmill/planning/planner_options.h"
#include "endmill/strategy/strategy.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "support/experiment.h"
#include "support/peak_memory.h"

using namespace endmill;

namespace {

// The bars, from the requirements of this project.
struct Bars {
    CsvCell start_s, best_s, cut_mm, ratio;
};

// What one surface or mesh is cut with.
struct Task {
    std::string name;
    Part part;
    BallCutter ball;
    StrategyOptions options;
};

double cpu_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The result of some work, and its CPU time in s.
template <typename Work>
auto timed(const Work& work)
{
    const double begin = cpu_s();
    auto result = work();
    return std::pair{std::move(result), cpu_s() - begin};
}

class EconomyTable {
public:
    void add(const std::string& row, double measured, const std::string& unit,
             const CsvCell& at_most = {})
    {
        table_.add_row({row, measured, unit, at_most});
    }

    void add_plan(const std::string& row, const StrategyPlan& plan, double seconds,
                  const CsvCell& seconds_at_most, const CsvCell& cut_at_most = {})
    {
        add(row + ", time", seconds, "s", seconds_at_most);
        add(row + ", cut by contacts", plan.economy.cut.contact_mm, "mm", cut_at_most);
        add(row + ", cut by tips", plan.economy.cut.tip_mm, "mm");
        add(row + ", left", plan.deviation.max_scallop_mm, "mm of stock");
        add(row + ", pieces", static_cast<double>(plan.covering.pieces), "pieces");
    }

    const CsvTable& table() const { return table_; }

private:
    CsvTable table_{{"row", "measured", "unit", "bar_at_most"}};
};

// The best path by tips beside that in parallel planes, which leave as much.
void add_planes(EconomyTable& table, const Task& task, double step)
{
    StrategyOptions options = task.options;
    options.distance = TravelKind::Tip;
    const double tolerance = options.inner_tolerance;
    const auto [best, best_s] =
        timed([&] { return plan_by_best_strategy(task.part, task.ball, options).plan; });
    table.add_plan(task.name + ", best by tips", best, best_s, {});
    const auto& surfaces = std::get<std::vector<Surface>>(task.part);
    const TriangleMesh mesh =
        sampled(surfaces, tool_side_signs(surfaces, Vec3::UnitZ()), tolerance / 2).mesh;
    const DropCutter drop{mesh, Cutter::ball(task.ball.radius())};
    DroppedPlanes planes{Angle::degrees(0), 1, step, tolerance / 2,
                         options.link.safe_height};
    JudgedPlanes shorter =
        fewest_planes(task.part, drop, planes, best.deviation.max_scallop_mm, tolerance);
    planes.direction = Angle::degrees(90);
    const JudgedPlanes across =
        fewest_planes(task.part, drop, planes, best.deviation.max_scallop_mm, tolerance);
    if (shorter.cut_mm < across.cut_mm)
        planes.direction = Angle::degrees(0);
    else
        shorter = across;
    planes.planes = shorter.planes;
    const auto [path, path_s] = timed([&] {
        return dropped_planes(DropCutter{mesh, Cutter::ball(task.ball.radius())}, planes);
    });
    const std::string row = task.name + ", parallel planes";
    table.add(row + ", time", path_s, "s");
    table.add(row + ", cut by tips", shorter.cut_mm, "mm");
    table.add(row + ", left", shorter.left_mm, "mm of stock");
    table.add(row + ", pitch", shorter.pitch, "mm");
    table.add(row + ", cut by tips over best", shorter.cut_mm / best.economy.cut.tip_mm,
              "times ours");
}

// One strategy, all of them, and the bound.
void add_surface(EconomyTable& table, const Task& task, const Bars& bars)
{
    const auto [one, one_s] = timed([&] {
        return plan_by_strategy(Strategy::IsoScallop, task.part, task.ball, task.options);
    });
    table.add_plan(task.name + ", iso-scallop", one, one_s, bars.start_s, bars.cut_mm);
    const auto [best, best_s] = timed(
        [&] { return plan_by_best_strategy(task.part, task.ball, task.options).plan; });
    table.add_plan(task.name + ", best", best, best_s, bars.best_s, bars.cut_mm);
    BoundProblem problem{task.ball, task.options.scallop_height};
    problem.stray = task.options.inner_tolerance;
    problem.most_pieces = static_cast<int>(best.covering.pieces);
    const auto& surfaces = std::get<std::vector<Surface>>(task.part);
    const auto [bound, bound_s] = timed([&] {
        return estimated_bound(surfaces, tool_side_signs(surfaces, Vec3::UnitZ()),
                               problem);
    });
    table.add(task.name + ", bound, time", bound_s, "s", 15);
    table.add(task.name + ", best over bound",
              best.economy.cut.contact_mm / bound.bound_mm.value(), "1", bars.ratio);
}

// A mesh by two strategies. Memory is measured first, before this process has used any.
void add_mesh(EconomyTable& table, const Task& task)
{
    constexpr std::array strategies{Strategy::Planar, Strategy::IsoScallop};
    constexpr std::size_t triangles_of_bars = 1'000'000;
    const bool has_bars =
        std::get<TriangleMesh>(task.part).triangles().size() >= triangles_of_bars;
    const auto row = [&](Strategy strategy) {
        return task.name + ", " + std::string{strategy_name(strategy)};
    };
    const auto plan = [&](Strategy strategy) {
        return plan_by_strategy(strategy, task.part, task.ball, task.options);
    };
    for (const Strategy strategy : strategies)
        table.add(row(strategy) + ", memory",
                  1e-6 * peak_memory_bytes([&] { plan(strategy); }), "MB",
                  has_bars ? CsvCell{2000.0} : CsvCell{});
    for (const Strategy strategy : strategies) {
        const auto [one, one_s] = timed([&] { return plan(strategy); });
        table.add_plan(row(strategy), one, one_s, has_bars ? CsvCell{60.0} : CsvCell{});
    }
}

Task surface_task(const std::string& name, const BallCutter& ball,
                  StrategyOptions options)
{
    const std::vector<Surface> surfaces{dataset_surface(name)};
    options.link.safe_height = default_safe_height(surfaces, Vec3::UnitZ());
    return {name, surfaces, ball, options};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/economy", [](Experiment& run) {
        const BallCutter ball{run.number("diameter_mm") / 2};
        StrategyOptions options;
        options.scallop_height = run.number("scallop_mm");
        options.inner_tolerance = run.number("inner_tolerance_mm");
        const double step = run.number("planes_step_mm");
        EconomyTable table;
        set_thread_count(1);
        const int cells = static_cast<int>(run.number("mesh_cells"));
        StrategyOptions on_mesh = options;
        on_mesh.link.safe_height = 10;
        add_mesh(table, {"mesh", grid_part(cells, wavy_height), ball, on_mesh});
        const Task net = surface_task(run.text("net"), ball, options);
        add_surface(table, net, {2, 8, 11'400, 1.18});
        add_planes(table, net, step);
        for (const std::string& name : run.texts("surfaces"))
            add_planes(table, surface_task(name, ball, options), step);
        run.write_result(table.table());
    });
}
