// SPDX-License-Identifier: GPL-3.0-or-later
// Paths by the planner of Kim & Choi and by verified planning over all surfaces, judged
// by the material that their straight motions leave.
//
//   verification-paths-judged OUTPUT_FOLDER
//
// Deterministic, under 20 s on two cores. Columns: README.md beside this.

#include "support/experiment.h"
#include "verification/paths-judged/tables.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "verification/paths-judged", [](Experiment& run) {
        CsvTable result = judged_table();
        const auto add_all = [&](const std::vector<std::string>& names, double diameter) {
            for (const std::string& name : names)
                add_judged_paths(result, name, dataset_surface(name),
                                 BallCutter{diameter / 2});
        };
        add_all(run.texts("surfaces"), run.number("diameter_mm"));
        add_all(run.texts("narrow_surfaces"), run.number("narrow_diameter_mm"));
        run.write_result(result);
    });
}
