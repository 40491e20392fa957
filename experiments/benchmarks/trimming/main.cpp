// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the trimming methods, of the slicer before them and of a whole trim, with the
// bars.
//
//   benchmarks-trimming OUTPUT_FOLDER
//
// About 40 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "benchmarks/trimming/measured_methods.h"
#include "benchmarks/trimming/whole_trim.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

constexpr double whole_bar_ms = 60;  // on two threads

void add_methods(Experiment& run, CsvTable& result, SectionPlan plan)
{
    for (const double feed : run.numbers("feeds_deg"))
        for (const double grid : run.numbers("grids")) {
            plan.direction_deg = feed;
            plan.grid_lines = static_cast<int>(grid);
            const std::string place =
                "at " + to_text(feed) + " deg, grid " + to_text(grid);
            add_offset(result, place, plan,
                       {run.texts("kinds"), run.numbers("stated " + place),
                        run.number("step_mm")});
        }
}

void add_searches(Experiment& run, CsvTable& result, SectionPlan plan)
{
    plan.grid_lines = 100;
    for (const double feed : run.numbers("feeds_deg")) {
        plan.direction_deg = feed;
        add_search(result, "at " + to_text(feed) + " deg", plan);
    }
}

void add_whole(Experiment& run, CsvTable& result)
{
    set_thread_count(2);
    const double R = run.number("radius_mm");
    const std::vector<Surface> part{dataset_surface(run.text("surface"))};
    const std::pair<const char*, Cutter> cutters[]{
        {"ball", Cutter::ball(R)},
        {"bull-nose", Cutter{R, run.number("corner_radius_mm")}},
        {"flat", Cutter::flat(R)}};
    const WholeTrim whole{part, static_cast<int>(run.number("whole_trim_grid")),
                          static_cast<int>(run.number("planes"))};
    for (const auto& [name, cutter] : cutters)
        add_benchmark(name, [&whole, tool = cutter] { return whole.moves(tool); });
    const ShortestTimes times = shortest_times();
    for (const auto& [name, cutter] : cutters)
        add_measured(result, std::string{"whole trim, "} + name,
                     1e3 * times.of(name).wall_s, "ms",
                     cutter.is_ball() ? CsvCell{whole_bar_ms} : CsvCell{});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/trimming", [](Experiment& run) {
        set_thread_count(1);
        CsvTable result{{"row", "measured", "unit", "bar", "ratio"}};
        const SectionPlan plan{.surface = run.text("surface"),
                               .cutter = Cutter::ball(run.number("radius_mm")),
                               .planes = static_cast<int>(run.number("planes"))};
        add_methods(run, result, plan);
        add_searches(run, result, plan);
        add_whole(run, result);
        run.write_result(result);
    });
}
