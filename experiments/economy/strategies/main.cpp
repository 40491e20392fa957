// SPDX-License-Identifier: GPL-3.0-or-later
// Every strategy on every surface, with several balls and scallop heights: length, points,
// pieces, the lower bound, and the verdict of the simulated cut.
//
//   economy-strategies OUTPUT_FOLDER
//
// Deterministic but for the times. Columns: README.md beside this.

#include "economy/strategies/tables.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/strategies", [](Experiment& run) {
        CsvTable result = strategies_table();
        const std::vector<double> scallops = run.numbers("scallops_mm");
        const auto add_all = [&](const std::vector<std::string>& names,
                                 const std::vector<double>& diameters) {
            for (const std::string& name : names)
                for (const double diameter : diameters)
                    for (const double scallop : scallops)
                        add_strategies(result, name, dataset_surface(name),
                                       {BallCutter{diameter / 2}, scallop});
        };
        add_all(run.texts("surfaces"), run.numbers("diameters_mm"));
        add_all(run.texts("narrow_surfaces"), run.numbers("narrow_diameters_mm"));
        run.write_result(result);
    });
}
