// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and accuracy of the cutting coefficients of a ball-end cutter and of their table,
// and speed of the largest loads of a helical cutter.
//
//   benchmarks-coefficients OUTPUT_FOLDER
//
// About 10 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <algorithm>
#include <numbers>

#include "benchmarks/coefficients/measured_errors.h"
#include "benchmarks/coefficients/random_engagements.h"
#include "endmill/process/detail/force_pattern.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

void add_accuracies(const std::vector<BallEngagement>& engagements, CsvTable& result)
{
    const auto add = [&](const std::string& name, double accuracy, double bar) {
        const auto at = [=](const BallEngagement& engagement) {
            return cutting_coefficients(engagement, ChipModel::Paper, accuracy);
        };
        const auto one = [&](const BallEngagement& engagement) {
            return at(engagement).I1;
        };
        const std::vector<double> errors = sorted_errors(engagements, at);
        result.add_row({name, us_a_point(engagements, one), "us a point", bar});
        const std::size_t count = errors.size();
        result.add_row({name + ", median error", errors[count / 2], "1", accuracy});
        result.add_row({name + ", 95 % error", errors[count * 95 / 100], "1", accuracy});
        result.add_row({name + ", largest error", errors.back(), "1", accuracy});
    };
    add("1e-6", 1e-6, 8);
    add("1e-10", 1e-10, 60);
    const auto exact = [](const BallEngagement& engagement) {
        return cutting_coefficients(engagement, ChipModel::Exact).I1;
    };
    result.add_row(
        {"1e-10, exact chip", us_a_point(engagements, exact), "us a point", 60});
}

void add_table(const std::vector<BallEngagement>& engagements, CsvTable& result)
{
    const CoefficientTable table;
    const auto look_up = [&](const BallEngagement& engagement) {
        return table.coefficients(engagement);
    };
    const auto one = [&](const BallEngagement& engagement) {
        return look_up(engagement).I1;
    };
    const std::vector<double> errors = sorted_errors(engagements, look_up);
    result.add_row({"table", us_a_point(engagements, one), "us a point", 0.15});
    result.add_row({"table, median error", errors[errors.size() / 2], "1", {}});
    result.add_row({"table, largest error", errors.back(), "1", 0.025});
}

void add_peaks(std::vector<BallEngagement> engagements, CsvTable& result)
{
    constexpr std::size_t some = 300;
    engagements.resize(std::min(engagements.size(), some));
    const MillingTool tool{5, 2, std::numbers::pi / 6};
    const LoadModel model{{2000, 0.016, 0.4, 0.4, 0.2, 0.6, 0.37, 28}, 5};
    const auto torque = [&](const BallEngagement& engagement) {
        return ForcePattern{engagement, ChipModel::Paper, tool}.peak_factor();
    };
    const auto direct = [&](const BallEngagement& engagement) {
        const ForcePattern pattern{engagement, ChipModel::Paper, tool};
        return pattern.direct_bounds(model, {1200, 450, 20}).cutting_force.value_or(0);
    };
    result.add_row({"torque", us_a_point(engagements, torque), "us a point", 1000});
    result.add_row({"direct", us_a_point(engagements, direct), "us a point", 1000});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/coefficients", [](Experiment& run) {
        const std::vector<BallEngagement> engagements =
            random_engagements(static_cast<int>(run.number("engagements")));
        CsvTable result{{"row", "measured", "unit", "bar_at_most"}};
        add_accuracies(engagements, result);
        add_table(engagements, result);
        add_peaks(engagements, result);
        run.write_result(result);
    });
}
