// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of step and threshold of method 1 on the first literal folds of sections:
// crossings found and missed, scanned lines, error, and time relative to method 2.
//
//   interference-increment OUTPUT_FOLDER
//
// Under 10 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "endmill/core/text.h"
#include "interference/increment/scan_rows.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

// The reference numbers for the feed along x, one row for each step.
void add_stated(Experiment& run, CsvTable& result, const std::vector<double>& steps)
{
    constexpr const char* columns[]{"hits",
                                    "lines_a_fold",
                                    "error_mm",
                                    "hits_at_4",
                                    "lines_a_fold_at_4",
                                    "error_at_4_mm",
                                    "search_over_method_2"};
    for (const double step : steps) {
        const auto stated = run.numbers("stated_" + to_text(step));
        NamedCells cells;
        for (std::size_t k = 0; k < std::size(columns); ++k)
            cells.emplace_back(columns[k], stated.at(k));
        add_named(result, "at 0 deg, step " + to_text(step) + ", stated", cells);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/increment", [](Experiment& run) {
        CsvTable result{{"row", "folds", "hits", "missed", "lines_a_fold", "error_mm",
                         "hits_at_4", "missed_at_4", "false_hits_at_4",
                         "crossings_in_condition", "missed_in_condition",
                         "lines_a_fold_at_4", "error_at_4_mm", "search_over_method_2",
                         "fewest_missed", "most_missed", "most_missed_at_4",
                         "lines_ratio", "time_ratio"}};
        const auto steps = run.numbers("steps_mm");
        for (const double feed : run.numbers("feeds_deg")) {
            const SectionPlan plan{run.text("surface"),
                                   Cutter::ball(run.number("radius_mm")), feed,
                                   static_cast<int>(run.number("grid_lines"))};
            add_scans(result, "at " + to_text(feed) + " deg", offset_sections(plan),
                      steps);
        }
        const int points = static_cast<int>(run.number("points"));
        add_planar_folds(result, "hard cases", hard_profiles(), points);
        add_planar_folds(result, "wavy", wavy_profiles(), points);
        add_stated(run, result, steps);
        run.write_result(result);
    });
}
