// SPDX-License-Identifier: GPL-3.0-or-later
// Section 5 of Park & Maeng, "cutters of a larger diameter are preferable if possible":
// cutting time of the test surface by the radius of the ball, with the tool limits fixed
// and in proportion to the square of the radius.
//
//   ball-end-milling-cutter-size OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <functional>

#include "endmill/core/text.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

// The job with a ball of `radius` and its force limits times `factor`; its torque limit
// grows with the radius besides.
MillingJob job_of(const MillingJob& reference, double radius, double factor)
{
    MillingJob job = reference;
    job.tool.limits.cutting_force_n = factor * *reference.tool.limits.cutting_force_n;
    job.tool.limits.thrust_n = factor * *reference.tool.limits.thrust_n;
    job.tool.limits.torque_n_m =
        factor * radius / reference.tool.radius * *reference.tool.limits.torque_n_m;
    job.tool.radius = radius;
    return job;
}

// The radii, and the options of every plan.
struct Sweep {
    std::vector<double> radii;
    FeedPlanOptions options;
};

// Adds the times of one data set for every radius, and whether they always fall. \return
// that.
bool add_set(CsvTable& result, CsvTable& times, const std::string& material,
             bool is_scaled, const Sweep& sweep)
{
    const MillingJob reference = reference_job(material);
    const std::string set =
        material + (is_scaled ? ", limits by r0 squared" : ", limits fixed");
    std::vector<double> minutes;
    for (const double radius : sweep.radii) {
        OneWayPasses passes = reference_passes();
        passes.radius = radius;
        const double ratio = radius / reference.tool.radius;
        const MillingJob job = job_of(reference, radius, is_scaled ? ratio * ratio : 1);
        const FeedPlanTotals totals =
            feed_plan(milled_path(passes).cuts, job, sweep.options).totals;
        minutes.push_back(totals.cut_min);
        add_named(result, set + ", r0 = " + to_text(radius),
                  {{"radius_mm", radius},
                   {"cl_length_mm", totals.length_mm},
                   {"cut_min", totals.cut_min},
                   {"infeasible", static_cast<std::int64_t>(totals.infeasible)}});
        times.add_row({set + " " + to_text(radius), radius, totals.cut_min, set});
    }
    const bool falls = std::ranges::is_sorted(minutes, std::ranges::greater{});
    add_named(result, set, {{"falls_always", word(falls)}});
    return falls;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/cutter-size", [](Experiment& run) {
            CsvTable result{{"row", "radius_mm", "cl_length_mm", "cut_min", "infeasible",
                             "falls_always"}};
            CsvTable times{{"row", "radius_mm", "cut_min", "limits"}};
            const Sweep sweep{run.numbers("radii_mm"),
                              {.accuracy = run.number("accuracy")}};
            bool falls_in_every_set = true;
            for (const std::string& material : run.texts("materials"))
                for (const bool is_scaled : {false, true})
                    falls_in_every_set &=
                        add_set(result, times, material, is_scaled, sweep);
            add_named(result, "claims in every set",
                      {{"falls_always", word(falls_in_every_set)}});
            run.write_result(result);
            run.write("times.csv", times.text());
        });
}
