// SPDX-License-Identifier: GPL-3.0-or-later
// Equations (6) to (21) of Kang & Suh and the lines of their two procedures, each compared
// on random sets of directions with the text, with another printed form or with the exact
// result.
//
//   five-axis-setup-equations OUTPUT_FOLDER
//
// Deterministic, under 5 s. Columns and verdicts: README.md beside this.

#include <cstdint>
#include <utility>
#include <vector>

#include "five-axis-setup/equations/rectangle_checks.h"
#include "five-axis-setup/equations/sector_checks.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/equations", [](Experiment& run) {
        CsvTable result{{"row", "cases", "differ", "largest_difference_deg",
                         "largest_residual", "as_printed", "as_text",
                         "edges_less_vertices", "mean_ratio", "largest_ratio"}};
        const auto sets = static_cast<int>(run.number("sets"));
        const RandomSets random{static_cast<std::uint64_t>(run.number("seed"))};
        using Check = NamedCells (*)(RandomSets, int);
        const std::vector<std::pair<const char*, Check>> checks{
            {"(6): least double sector", sectors_against_all_ends},
            {"(7): widths of both intervals", interval_widths},
            {"(8): both forms of theta_j", width_forms},
            {"(12): third line", third_condition},
            {"(13): solid angle at least F", area_against_solid_angle},
            {"CA_Type: choice of CR2", choice_of_second_end},
            {"CA_Type: theta_j", width_of_procedure},
            {"CA_Type: parts of the width", parts_of_width},
            {"CA_Type: phi", length_of_procedure},
            {"CA_Type: strict comparisons", strict_comparisons},
            {"CA_Type: reported pose", reported_sector},
            {"hull by projection", hulls_by_projection},
            {"hull edges", hull_edges},
            {"(14): supporting vertices", supporting_vertices},
            {"(15), (16): directions of R1 and R2", axis_residuals},
            {"(17): beta about the initial R2", signs_about_initial_axis},
            {"(18): projections", projection_roots},
            {"(19): extremes over the hull's vertices", extremes_over_vertices},
            {"(20): limits without signs", unsigned_limits},
            {"AB_Type: one index", ranges_by_one_index},
            {"AB_Type: strict comparisons", strict_rectangle_comparisons},
            {"AB_Type: reported pose", reported_rectangle},
            {"(21): solid angle at least F", rectangle_against_solid_angle},
            {"near optimal rectangles", near_optimal_rectangles}};
        for (const auto& [row, check] : checks)
            add_named(result, row, check(random, sets));
        run.write_result(result);
    });
}
