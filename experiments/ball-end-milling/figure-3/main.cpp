// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 3 of Park & Maeng: I1 against the slopes across and along the feed. The depth is
// the radius of the ball, the pick feed half of it.
//
//   ball-end-milling-figure-3 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "endmill/core/angle.h"
#include "endmill/core/text.h"
#include "endmill/process/cutting_coefficients.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

class Figure {
public:
    explicit Figure(Experiment& run)
        : pick_feed_{run.number("pick_feed_ratio")},
          depth_{run.number("depth_ratio")}
    {
    }

    double i1(double mu, double lambda, ChipModel chip) const
    {
        return cutting_coefficients(
                   {Angle::degrees(mu).radians(), Angle::degrees(lambda).radians(),
                    pick_feed_, depth_},
                   chip)
            .I1;
    }

private:
    double pick_feed_;
    double depth_;
};

CsvTable curves(Experiment& run, const Figure& figure)
{
    CsvTable result{{"row", "mu_deg", "lambda_deg", "i1", "i1_exact_chip"}};
    for (const double lambda : run.numbers("lambda_deg"))
        for (const double mu : run.numbers("mu_deg"))
            result.add_row({"mu " + to_text(mu) + ", lambda " + to_text(lambda), mu,
                            lambda, figure.i1(mu, lambda, ChipModel::Paper),
                            figure.i1(mu, lambda, ChipModel::Exact)});
    return result;
}

// Both slopes from -reach to reach.
CsvTable surface(Experiment& run, const Figure& figure)
{
    const double reach = run.number("surface_reach_deg");
    const int steps = static_cast<int>(run.number("surface_steps"));
    CsvTable table{{"mu_deg", "lambda_deg", "i1"}};
    for (int row = -steps; row <= steps; ++row)
        for (int column = -steps; column <= steps; ++column) {
            const double mu = reach * column / steps;
            const double lambda = reach * row / steps;
            table.add_row({mu, lambda, figure.i1(mu, lambda, ChipModel::Paper)});
        }
    return table;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-3", [](Experiment& run) {
        const Figure figure{run};
        run.write_result(curves(run, figure));
        run.write("surface.csv", surface(run, figure).text());
    });
}
