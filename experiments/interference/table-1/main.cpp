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
#include "support/named_cells.h"

using namespace endmill;

namespace {

constexpr double rounding_s = 0.5;  // of the printed seconds

// Range of a / b when both are rounded.
NamedCells ratio_cells(double a, double b)
{
    return {{"ratio_least", (a - rounding_s) / (b + rounding_s)},
            {"ratio_greatest", (a + rounding_s) / (b - rounding_s)}};
}

void add_printed(Experiment& run, CsvTable& result)
{
    const auto all = run.numbers("printed_100_s");
    const auto half = run.numbers("printed_50_s");
    for (std::size_t k = 0; k < all.size(); ++k)
        add_named(result, "print, method " + std::to_string(k + 1) + ", 100 to 50",
                  ratio_cells(all[k], half.at(k)));
    for (const auto& [planes, seconds] : {std::pair{"100", all}, std::pair{"50", half}})
        for (const std::size_t k : {0, 1})
            add_named(result,
                      "print, " + std::string{planes} + " planes, method " +
                          std::to_string(k + 1) + " to " + std::to_string(k + 2),
                      ratio_cells(seconds.at(k), seconds.at(k + 1)));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/table-1", [](Experiment& run) {
        set_thread_count(1);
        CsvTable result{{"row", "trim_100_ms", "trim_50_ms", "ratio_100_to_50",
                         "proportional_to_planes", "over_method_2", "with_slicing_100_ms",
                         "with_slicing_50_ms", "with_slicing_100_to_50", "step_mm",
                         "ratio_least", "ratio_greatest", "method"}};
        for (const double feed : run.numbers("feeds_deg"))
            add_measured(run, result, feed);
        add_printed(run, result);
        run.write_result(result);
    });
}
