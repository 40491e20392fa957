// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the printed tables, tested on each fitted net: scaling laws, savings,
// cells, and the scallops between passes by an independent construction.
//
//   economic-cl-data-acceptance OUTPUT_FOLDER
//
// Deterministic, under 5 s. Columns: README.md beside this.

#include "economic-cl-data/acceptance/tables.h"
#include "support/experiment.h"
#include "support/printed_tables.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/acceptance", [](Experiment& run) {
        const EconomyTables printed = printed_tables();
        CsvTable result{acceptance_columns()};
        for (const std::string& name : run.texts("surfaces"))
            result.add_row(
                acceptance_row(name, acceptance_of(dataset_surface(name)), printed));
        run.write_result(result);
    });
}
