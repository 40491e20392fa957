// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 5 of Kim & Choi: the scallop height between passes against the curvature across
// them and the radius of the ball.
//
//   economic-cl-data-figure-5 OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns: README.md beside this.

#include "economic-cl-data/figure-5/trends.h"
#include "endmill/core/text.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

void add_curve(CsvTable& result, const BallCutter& ball, double curvature,
               const std::vector<double>& intervals)
{
    for (const double interval : intervals)
        if (const auto height = scallop_if_any(ball, curvature, interval))
            result.add_row({"R=" + to_text(ball.radius()) + " k=" + to_text(curvature) +
                                " l=" + to_text(interval),
                            ball.radius(),
                            curvature,
                            interval,
                            *height,
                            {}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/figure-5", [](Experiment& run) {
        Sweep sweep;
        const double step = run.number("interval_step_mm");
        for (int i = 1; i * step <= run.number("longest_interval_mm"); ++i)
            sweep.intervals.push_back(i * step);
        sweep.radii = run.numbers("radii_mm");
        sweep.curvatures = run.numbers("curvatures_per_mm");
        sweep.scallops = run.numbers("scallops_mm");
        CsvTable result{{"row", "radius_mm", "curvature_per_mm", "interval_mm",
                         "scallop_mm", "pairs_percent"}};
        for (const double radius : sweep.radii)
            for (const double curvature : sweep.curvatures)
                add_curve(result, BallCutter{radius}, curvature, sweep.intervals);
        for (const auto& [trend, percent] : trends(sweep))
            result.add_row({trend, {}, {}, {}, {}, percent});
        run.write_result(result);
    });
}
