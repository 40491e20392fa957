// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the searches for a setup, on the teapot and 1200 directions.
//
//   benchmarks-setup-search OUTPUT_FOLDER
//
// About three minutes; measures time, so nothing else should run. Columns: README.md beside this.

#include "benchmarks/setup-search/bars.h"
#include "endmill/core/parallel.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/shortest_times.h"
#include "support/studied_part.h"

using namespace endmill;

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
        run.write_result(result);
    });
}
