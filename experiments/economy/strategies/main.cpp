// SPDX-License-Identifier: GPL-3.0-or-later
// Every strategy on every surface of the data sets, with several balls and scallop heights:
// length, points, pieces, the lower bound, and the verdict of the simulated cut.
//
//   economy-strategies OUTPUT_FOLDER
//
// Deterministic but for the times. Columns: README.md beside this. Exit 1 if a path is
// shorter than the bound, if a path that is not clean names no place, or if the best path is
// longer than a clean one along parameter lines.

#include "economy/strategies/tables.h"
#include "endmill/core/error.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/strategies", [](Experiment& run) {
        const std::vector<double> diameters = run.numbers("diameters_mm");
        const std::vector<double> scallops = run.numbers("scallops_mm");
        StrategiesTable table{run.number("most_squares")};
        for (const std::string& name : run.texts("surfaces")) {
            const Surface surface = dataset_surface(name);
            for (const double diameter : diameters)
                for (const double scallop : scallops)
                    table.add(name, surface, {BallCutter{diameter / 2}, scallop});
        }
        run.write_result(table.result());
        if (table.violations().empty())
            return;
        run.publish();
        throw DomainError{table.violations()};
    });
}
