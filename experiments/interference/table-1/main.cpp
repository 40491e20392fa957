// SPDX-License-Identifier: GPL-3.0-or-later
// Table 1 of Jang, Kim and Jeong: the times of the three methods at 50 and 100 planes,
// the conclusions that the printed times support, and our times on a part of this
// project.
//
//   interference-table-1 OUTPUT_FOLDER
//
// Under 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "endmill/core/parallel.h"
#include "interference/table-1/measured_times.h"
#include "interference/table-1/printed_times.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/table-1", [](Experiment& run) {
        set_thread_count(1);
        CsvTable result{{"row", "trim_100_ms", "trim_50_ms", "ratio_100_to_50",
                         "proportional_to_planes", "over_method_2", "over_method_2_at_50",
                         "within_print", "within_print_at_50", "with_slicing_100_ms",
                         "with_slicing_50_ms", "with_slicing_100_to_50", "step_mm",
                         "method", "ratio_least", "ratio_greatest",
                         "print_allows_proportional", "printed_fastest"}};
        for (const double feed : run.numbers("feeds_deg"))
            add_measured(run, result, feed);
        add_printed(result, proportional_ratio);
        run.write_result(result);
    });
}
