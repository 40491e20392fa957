// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements of the simulation against closed forms, for finer and finer rays and
// cells.
//
//   verification-convergence OUTPUT_FOLDER
//
// Deterministic, under 5 s on two cores. Columns: README.md beside this.

#include "endmill/core/text.h"
#include "endmill/verification/detail/closed_forms.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// Adds value, error, error bound, and whether the bound holds.
void add_cells(std::vector<CsvCell>& cells, const ClosedForm& form,
               const MeasuredValue& measured)
{
    CsvCell bound;
    if (measured.bound)
        bound = *measured.bound;
    CsvCell holds;
    if (const Answer answer = bound_holds(form, measured); answer != Answer::Undecided)
        holds = std::string{answer == Answer::Yes ? "yes" : "no"};
    cells.insert(cells.end(),
                 {measured.value, measured.value - form.exact, bound, holds});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "verification/convergence", [](Experiment& run) {
        const std::vector<double> pitches = run.numbers("pitches_mm");
        const auto max_refine = static_cast<int>(run.number("max_refine"));
        CsvTable result{{"row", "quantity", "unit", "pitch_mm", "exact", "measured",
                         "error", "bound", "holds", "refined", "refined_error",
                         "refined_bound", "refined_holds"}};
        for (const ClosedForm& form : closed_forms())
            for (const double pitch : pitches) {
                std::vector<CsvCell> cells{form.name + " g=" + to_text(pitch), form.name,
                                           form.unit, pitch, form.exact};
                add_cells(cells, form, form.measure(pitch, 0));
                if (form.can_refine)
                    add_cells(cells, form, form.measure(pitch, max_refine));
                else
                    cells.resize(cells.size() + 4);
                result.add_row(cells);
            }
        run.write_result(result);
    });
}
