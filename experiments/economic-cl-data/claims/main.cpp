// SPDX-License-Identifier: GPL-3.0-or-later
// The percentages in the text of Kim & Choi as means over the tables: over the printed
// cells, and over the cells of the fitted nets.
//
//   economic-cl-data-claims OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "economic-cl-data/claims/stated_savings.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/printed_tables.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/claims", [](Experiment& run) {
        CsvTable result{{"row", "ncl_v_against_u_percent", "tcd_v_against_u_percent",
                         "ncl_v_against_u_finest_percent", "v_d10_d20_percent",
                         "larger_is_better", "d10_d20_percent",
                         "ncl_v_against_u_least_percent", "tcd_v_against_u_least_percent",
                         "v_beats_u", "last_column"}};
        for (const auto& [name, tables] : print_and_nets(run.texts("surfaces"))) {
            const StatedSavings savings = stated_savings(tables);
            result.add_row(
                {name, 100 * savings.points_between_directions,
                 100 * savings.travel_between_directions,
                 100 * savings.points_at_finest_tolerance,
                 100 * savings.by_diameter_along_v, word(savings.larger_is_better),
                 100 * savings.by_diameter, 100 * savings.least_points_between_directions,
                 100 * savings.least_travel_between_directions, word(savings.v_beats_u),
                 name == "print" ? CsvCell{columns_of_last_column(tables)} : CsvCell{}});
        }
        run.write_result(result);
    });
}
