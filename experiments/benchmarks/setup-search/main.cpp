// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the searches for a setup, on the teapot and a closed part of 1e5 facets with
// 1200 directions, and of the best pose for many directions.
//
//   benchmarks-setup-search OUTPUT_FOLDER
//
// About five minutes; measures time, so nothing else should run. Columns: README.md beside this.

#include <cmath>
#include <cstdint>
#include <ctime>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/setup-search/bars.h"
#include "benchmarks/setup-search/bumpy_ball.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/pose_search.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/shortest_times.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

// Directions up to 72 degrees from +Z, as a spiral with steps of the golden angle.
std::vector<Vec3> spiral_of_directions(int count)
{
    constexpr double golden_angle = 2 * std::numbers::pi * (2 - std::numbers::phi);
    std::vector<Vec3> all;
    for (int k = 0; k < count; ++k) {
        const double z = 1 - 0.7 * (k + 0.5) / count;
        const double across = std::sqrt(1 - z * z);
        all.emplace_back(across * std::cos(golden_angle * k),
                         across * std::sin(golden_angle * k), z);
    }
    return all;
}

double best_area(std::span<const Vec3> directions)
{
    return pose_fit(Vec3::UnitZ(), directions, {.mode = SetupMode::Corrected})
        .least->area;
}

// The search over whole cones for a closed part of many facets. It takes so long that it
// runs once.
void add_closed_part(CsvTable& result, const StudiedPart& part, const std::string& family)
{
    SearchBar bar = whole_cones_search(family, "floored-area", 0.05, 90, 60);
    const std::clock_t begin = std::clock();
    const PartSetup best = five_axis_setup(part.grid, part.visibility.map, bar.request);
    const double cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const double proved =
        100 * (best.objective.value() / best.certificate.value().lower_bound - 1);
    result.add_row({bar.name + ", bumpy ball", cpu_s, "s", bar.at_most_s, proved});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/setup-search", [](Experiment& run) {
        set_thread_count(1);
        const TriangleMesh teapot = dataset_mesh(run.text("mesh"));
        const std::string grid = run.text("grid");
        const std::vector<SearchBar> all = search_bars();
        for (const SearchBar& bar : all) {
            const StudiedPart part = studied_part(teapot, grid, bar.incidence);
            add_benchmark(bar.name, [part, request = bar.request] {
                return five_axis_setup(part.grid, part.visibility.map, request).objective;
            });
        }
        const auto many =
            spiral_of_directions(static_cast<std::int32_t>(run.number("directions")));
        const std::string many_name = "corrected, CA, many directions";
        add_benchmark(many_name, [&] { return best_area(many); });
        const ShortestTimes times = shortest_times();
        CsvTable result{{"row", "measured", "unit", "bar_at_most", "proved_percent"}};
        for (const SearchBar& bar : all) {
            const StudiedPart part = studied_part(teapot, grid, bar.incidence);
            const PartSetup best =
                five_axis_setup(part.grid, part.visibility.map, bar.request);
            CsvCell proved;
            if (best.certificate)
                proved =
                    100 * (best.objective.value() / best.certificate->lower_bound - 1);
            result.add_row(
                {bar.name, times.of(bar.name).cpu_s, "s", bar.at_most_s, proved});
        }
        result.add_row({many_name, times.of(many_name).cpu_s, "s", 10, CsvCell{}});
        const StudiedPart ball =
            studied_part(bumpy_ball(static_cast<std::int32_t>(run.number("meridians"))),
                         grid, Angle::degrees(90));
        for (const std::string family : {"AB", "CA"})
            add_closed_part(result, ball, family);
        run.write_result(result);
    });
}
