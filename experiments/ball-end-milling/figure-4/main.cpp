// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 4 of Park & Maeng: the tool-life equation, fitted again to the printed data and
// also computed from the printed exponent; eq. (5) as printed, with C_b held fixed.
//
//   ball-end-milling-figure-4 OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns and verdicts: README.md beside this.

#include <cmath>

#include "ball-end-milling/figure-4/single_precision.h"
#include "ball-end-milling/figure-4/tables.h"
#include "endmill/files/input_csv.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-4", [](Experiment& run) {
        const PrintedSpeeds printed{
            read_cutting_speeds(run.text("data")),
            run.numbers("printed_phi_deg"),
            run.numbers("printed_ln_phi_over_pi"),
            run.numbers("printed_ln_v"),
            {run.number("tool_change_min"), run.number("tool_cost"),
             run.number("machine_cost_per_min")}};
        const double alpha = run.number("printed_alpha");
        const double cb = run.number("printed_cb");
        CsvTable result{tool_life_columns()};
        const auto widths = run.numbers("widths_over_diameter");
        const double printed_pi = run.number("printed_pi");
        add_data(result, printed, widths, printed_pi);
        const SpeedLine line = fitted_speed_line(printed.data);
        add_line(result, "refit", printed, line);
        add_named(result, "refit over print",
                  {{"alpha_off", std::abs(line.alpha / alpha - 1)}});
        add_line(result, "printed exponent", printed,
                 fitted_speed_line(printed.data, alpha));
        const SinglePrecisionFits fits =
            single_precision_fits(printed, widths, printed_pi, alpha);
        add_named(result, "single precision",
                  {{"fits", std::int64_t{fits.tried}},
                   {"fits_as_printed", std::int64_t{fits.as_printed}},
                   {"fits_in_order", std::int64_t{fits.in_order}},
                   {"alpha_least", fits.least},
                   {"alpha_greatest", fits.greatest}});
        add_printed_eq_5(result, printed, cb, alpha);
        add_costs(result, printed.costs, cb, alpha);
        run.write_result(result);
        CsvTable curve{{"row", "phi_over_pi", "v_m_per_min", "what"}};
        for (int i = 2; i <= 20; ++i)
            curve.add_row({std::to_string(i), 0.05 * i, economic_speed(line, 0.05 * i),
                           "line of least squares"});
        for (const CuttingSpeedDatum& datum : printed.data)
            curve.add_row({"datum", datum.phi_over_pi, datum.v_m_per_min, "data"});
        run.write("speeds.csv", curve.text());
    });
}
