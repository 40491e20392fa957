// SPDX-License-Identifier: GPL-3.0-or-later
// Defects of the path of Kim & Choi over the default net, with the results of an earlier
// independent implementation beside them.
//
//   verification-weaknesses OUTPUT_FOLDER
//
// Deterministic, under 30 s on two cores. Columns: README.md beside this.

#include "support/experiment.h"
#include "verification/weaknesses/tables.h"

using namespace endmill;

namespace {

// The reference number of the row; an empty cell if there is none.
CsvCell stated(const std::vector<std::string>& rows, const std::vector<double>& numbers,
               const std::string& row)
{
    for (std::size_t k = 0; k < rows.size() && k < numbers.size(); ++k)
        if (rows[k] == row)
            return numbers[k];
    return {};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "verification/weaknesses", [](Experiment& run) {
        const Surface surface = dataset_surface(run.text("surface"));
        const std::vector<std::string> rows = run.texts("stated_rows");
        const std::vector<double> stated_u = run.numbers("stated_u");
        const std::vector<double> stated_v = run.numbers("stated_v");
        PlanToJudge plan{BallCutter{run.number("diameter_mm") / 2},
                         run.number("tolerance_mm"), Parameter::U};
        const NamedNumbers u = weaknesses(surface, plan, run.number("rays"));
        plan.direction = Parameter::V;
        const NamedNumbers v = weaknesses(surface, plan, run.number("rays"));
        CsvTable result{{"row", "u", "reference_u", "v", "reference_v"}};
        for (std::size_t k = 0; k < u.size(); ++k) {
            const std::string& row = u[k].first;
            result.add_row({row, u[k].second, stated(rows, stated_u, row), v[k].second,
                            stated(rows, stated_v, row)});
        }
        run.write_result(result);
    });
}
