// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas of Kim & Choi against what they stand for: as printed, and corrected where the print
// contradicts itself.
//
//   economic-cl-data-formulas OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "economic-cl-data/formulas/circle_formulas.h"
#include "economic-cl-data/formulas/surface_formulas.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

void add_errors(CsvTable& result, const FormulaErrors& errors)
{
    for (const FormulaError& error : errors)
        result.add_row({error.row, error.cases, error.worst, {}});
}

std::vector<ScallopSection> sections(Experiment& run)
{
    const std::vector<double> radii = run.numbers("radii_mm");
    const std::vector<double> scallops = run.numbers("scallops_mm");
    const std::vector<double> sections = run.numbers("section_radii_mm");
    std::vector<ScallopSection> all;
    for (std::size_t k = 0; k < radii.size(); ++k)
        all.push_back({radii[k], scallops.at(k), sections.at(k)});
    return all;
}

std::vector<StepCase> steps(Experiment& run)
{
    const std::vector<double> radii = run.numbers("curve_radii_mm");
    const std::vector<double> tolerances = run.numbers("chord_tolerances_mm");
    std::vector<StepCase> all;
    for (std::size_t k = 0; k < radii.size(); ++k)
        all.push_back({radii[k], tolerances.at(k)});
    return all;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/formulas", [](Experiment& run) {
        const Surface surface = dataset_surface(run.text("surface"));
        const ClosedFormSurfaces closed{dataset_surface("sphere"),
                                        dataset_surface("torus"),
                                        dataset_surface("saddle")};
        CsvTable result{{"row", "cases", "worst_relative", "order"}};
        add_errors(result, patch_formula_errors(surface.patch(0, 0)));
        add_errors(result, step_formula_errors(steps(run)));
        add_errors(result, {next_point_error(surface)});
        add_errors(result, interval_formula_errors(sections(run)));
        add_errors(result, section_formula_errors(closed));
        result.add_row(
            {"eq. (8), other sections", {}, {}, order_of_chord_curvature(closed)});
        run.write_result(result);
    });
}
