// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the trimming methods, of the slicer before them and of a whole trim, with the
// bars.
//
//   benchmarks-trimming OUTPUT_FOLDER
//
// About 60 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "benchmarks/trimming/whole_trim.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/fold_scan.h"
#include "support/cpu_time.h"
#include "support/experiment.h"
#include "support/offset_sections.h"
#include "support/shortest_times.h"
#include "support/timed_trimming.h"

using namespace endmill;

namespace {

constexpr double ms = 1e3;
constexpr double allowed_share = 1.5;     // of the reference times
constexpr double march_bar = 1.15;        // of the time of method 2
constexpr double whole_bar_ms = 60;       // on two threads
constexpr double threshold_in_steps = 4;  // of method 1

TrimmingOptions literal(double step)
{
    return {.detection = FoldDetection::Literal,
            .scan_step = step,
            .scan_threshold = threshold_in_steps * step};
}

// CPU times in s of slicing and of each method. They are measured alternately, so that
// other processes disturb all of them equally.
std::vector<double> times_of(const std::vector<std::string>& kinds,
                             const OffsetSections& offset, double step)
{
    constexpr int turns = 25;
    constexpr double budget_s = 0.01;
    std::vector<double> times(kinds.size(), std::numeric_limits<double>::infinity());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            const double time =
                kinds[k] == "slicing"
                    ? shortest_cpu_s(
                          budget_s,
                          [&] { return slice(offset.offset.mesh, offset.planes).size(); })
                    : trimming_s(offset.sections, timed_method(kinds[k], literal(step)),
                                 budget_s);
            times[k] = std::min(times[k], time);
        }
    return times;
}

// Adds a row with a measured number and its bar, if it has one.
void add_row(CsvTable& result, const std::string& row, double measured,
             const std::string& unit, const CsvCell& bar = {})
{
    CsvCell ratio;
    if (const double* const most = std::get_if<double>(&bar))
        ratio = measured / *most;
    result.add_row({row, measured, unit, bar, ratio});
}

void add_methods(Experiment& run, CsvTable& result, SectionPlan plan)
{
    const auto kinds = run.texts("kinds");
    const double step = run.number("step_mm");
    for (const double feed : run.numbers("feeds_deg"))
        for (const double grid : run.numbers("grids")) {
            plan.direction_deg = feed;
            plan.grid_lines = static_cast<int>(grid);
            const std::string place =
                "at " + to_text(feed) + " deg, grid " + to_text(grid);
            const auto stated = run.numbers("stated " + place);
            const auto times = times_of(kinds, offset_sections(plan), step);
            const auto time = [&](std::string_view kind) {
                const auto found = std::ranges::find(kinds, kind);
                return times.at(static_cast<std::size_t>(found - kinds.begin()));
            };
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                std::string row = place;
                row += kinds[k] == "slicing" ? ", " : ", method ";
                row += kinds[k];
                add_row(result, row, ms * times[k], "ms", allowed_share * stated.at(k));
            }
            add_row(result, place + ", march to method 2", time("3 march") / time("2"),
                    "times", march_bar);
        }
}

// The search time of method 1 is inversely proportional to its step.
void add_search(Experiment& run, CsvTable& result, SectionPlan plan)
{
    constexpr double budget_s = 0.5;
    constexpr double coarse_share = 1.0 / 1000;  // of the radius
    plan.grid_lines = 100;
    for (const double feed : run.numbers("feeds_deg")) {
        plan.direction_deg = feed;
        const OffsetSections offset = offset_sections(plan);
        const auto folds = first_literal_folds(offset.sections);
        const auto time = [&](double step) {
            return shortest_cpu_s(budget_s, [&] {
                return crossings(folds, search_by_distance, literal(step));
            });
        };
        const double coarse = coarse_share * plan.cutter.radius();
        add_row(result, "at " + to_text(feed) + " deg, search at half the step",
                time(coarse / 2) / time(coarse), "times", "1.7 to 2.3");
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
        add_row(result, std::string{"whole trim, "} + name, ms * times.of(name).wall_s,
                "ms", cutter.is_ball() ? CsvCell{whole_bar_ms} : CsvCell{});
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
        add_search(run, result, plan);
        add_whole(run, result);
        run.write_result(result);
    });
}
