// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of Kim & Choi on the fitted nets and on surfaces that were not fitted: savings by
// direction and by ball, the recommended direction, and the travel that eq. (4), (5) still waste.
//
//   economic-cl-data-other-surfaces OUTPUT_FOLDER
//
// Deterministic, under 30 s. Columns and verdicts: README.md beside this.

#include "economic-cl-data/other-surfaces/tables.h"
#include "support/experiment.h"
#include "support/printed_tables.h"

using namespace endmill;

namespace {

std::vector<NamedStudy> studies(const std::vector<std::string>& names, double scale)
{
    std::vector<NamedStudy> all;
    for (const std::string& name : names)
        all.push_back({name, scale * table_diameters_mm[1],
                       study_surface(dataset_surface(name), scale)});
    return all;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "economic-cl-data/other-surfaces", [](Experiment& run) {
            const std::vector<NamedStudy> fitted =
                studies(run.texts("fitted_surfaces"), 1);
            std::vector<NamedStudy> others = studies(run.texts("surfaces"), 1);
            for (NamedStudy& narrow :
                 studies(run.texts("narrow_surfaces"), run.number("narrow_scale")))
                others.push_back(std::move(narrow));
            CsvTable result = study_table();
            for (const NamedStudy& named : fitted)
                add_study(result, named);
            for (const NamedStudy& named : others)
                add_study(result, named);
            add_counts(result, others);
            add_travel_against_plane(result, dataset_surface(run.text("plane")));
            run.write_result(result);
        });
}
