// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 5 of Kim & Choi: the scallop height between passes against the curvature across
// them and the radius of the ball.
//
//   economic-cl-data-figure-5 OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns: README.md beside this.

#include "endmill/core/text.h"
#include "endmill/planning/path_interval.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// The longest interval at which the balls still intersect above the section.
double longest_interval(const BallCutter& ball, double curvature)
{
    const double meeting = 2 * ball.radius() / (1 + curvature * ball.radius());
    return curvature == 0 ? meeting : std::min(meeting, 2 / std::abs(curvature));
}

void add_curve(CsvTable& result, const BallCutter& ball, double curvature,
               const std::vector<double>& intervals)
{
    for (const double interval : intervals)
        if (interval < longest_interval(ball, curvature))
            result.add_row({"R=" + to_text(ball.radius()) + " k=" + to_text(curvature) +
                                " l=" + to_text(interval),
                            ball.radius(), curvature, interval,
                            scallop_height(ball, curvature, interval)});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/figure-5", [](Experiment& run) {
        std::vector<double> intervals;
        const double step = run.number("interval_step_mm");
        for (int i = 1; i * step <= run.number("longest_interval_mm"); ++i)
            intervals.push_back(i * step);
        const std::vector<double> curvatures = run.numbers("curvatures_per_mm");
        CsvTable result{
            {"row", "radius_mm", "curvature_per_mm", "interval_mm", "scallop_mm"}};
        for (const double radius : run.numbers("radii_mm"))
            for (const double curvature : curvatures)
                add_curve(result, BallCutter{radius}, curvature, intervals);
        run.write_result(result);
    });
}
