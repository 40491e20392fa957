// SPDX-License-Identifier: GPL-3.0-or-later
// Table 1 of Kim & Choi: numbers of CL points along u and v for three tolerances and
// three balls, as printed and on nets fitted to it.
//
//   economic-cl-data-table-1 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "support/experiment.h"
#include "support/printed_tables.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/table-1", [](Experiment& run) {
        TablePolicies policies;
        policies.scallop_per_tolerance = run.number("scallop_per_tolerance");
        const auto tables = print_and_nets(run.texts("surfaces"), policies);
        run.write_result(economy_csv(tables, TableQuantity::Ncl));
    });
}
