// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding errors of the printed path interval, eq. (4) of Kim & Choi, on nearly flat
// sections, in double and in single precision, and of the form that this project uses.
//
//   economic-cl-data-noise OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns: README.md beside this.

#include <cmath>

#include "endmill/core/text.h"
#include "endmill/planning/detail/interval_forms.h"
#include "endmill/planning/path_interval.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

constexpr IntervalForm forms[] = {IntervalForm::Printed, IntervalForm::Squares,
                                  IntervalForm::Factors, IntervalForm::Expanded};

// Relative error; an empty cell if the value is not a number.
CsvCell relative_error(double value, double truth)
{
    if (std::isnan(value))
        return {};
    return std::abs(value - truth) / truth;
}

void add_case(CsvTable& result, const IntervalCase& at)
{
    const double truth = interval_in_50_digits(at);
    const PathInterval stable =
        path_interval(BallCutter{at.radius}, 1 / at.section_radius, at.scallop_height);
    std::vector<CsvCell> cells{"R=" + to_text(at.radius) +
                                   " h=" + to_text(at.scallop_height) +
                                   " rho=" + to_text(at.section_radius),
                               at.radius,
                               at.scallop_height,
                               at.section_radius,
                               truth,
                               relative_error(stable.chord, truth)};
    for (const Precision precision : {Precision::Double, Precision::Single})
        for (const IntervalForm form : forms)
            cells.push_back(relative_error(printed_interval(at, form, precision), truth));
    result.add_row(cells);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/noise", [](Experiment& run) {
        CsvTable result{{"row", "radius_mm", "scallop_mm", "section_radius_mm",
                         "interval_mm", "stable_double", "printed_double",
                         "squares_double", "factors_double", "expanded_double",
                         "printed_single", "squares_single", "factors_single",
                         "expanded_single"}};
        const std::vector<double> radii = run.numbers("radii_mm");
        const std::vector<double> scallops = run.numbers("scallops_mm");
        const std::vector<double> sections = run.numbers("section_radii_mm");
        for (std::size_t i = 0; i < radii.size(); ++i)
            for (const double section : sections)
                add_case(result, {radii[i], scallops.at(i), section});
        run.write_result(result);
    });
}
