// SPDX-License-Identifier: GPL-3.0-or-later
// Time of each trimming method against the number of points on a curve.
//
//   interference-complexity OUTPUT_FOLDER
//
// About 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <cmath>
#include <cstdint>

#include "endmill/core/parallel.h"
#include "endmill/trimming/detail/profile_families.h"
#include "support/cpu_time.h"
#include "support/experiment.h"
#include "support/timed_trimming.h"

using namespace endmill;

namespace {

constexpr double budget_s = 0.05;  // time of one measurement

// The parabola z = x^2 / (2 p), whose offset by a ball of radius above p has one loop.
OffsetProfile parabola(double p, double from, double to, double radius)
{
    return {"parabola",
            [p](double x) { return x * x / (2 * p); },
            [p](double x) { return x / p; },
            from,
            to,
            radius};
}

std::vector<PlaneSection> section_of(SectionCurve curve)
{
    std::vector<PlaneSection> sections(1);
    sections[0].curves.push_back(std::move(curve));
    return sections;
}

// The time of method 3 by scan grows with the product of the points on two branches.
bool is_too_slow(const TimedMethod& timed, double points, double most_by_scan)
{
    return timed.label == "3 scan" && points > most_by_scan;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/complexity", [](Experiment& run) {
        set_thread_count(1);
        const double p = run.number("parabola_mm");
        const double from = run.number("from_mm");
        const double to = run.number("to_mm");
        const OffsetProfile profile = parabola(p, from, to, run.number("radius_mm"));
        const double most_by_scan = run.number("most_points_by_scan");
        const double step = run.number("step_mm");
        const auto sizes = run.numbers("points");
        CsvTable result{{"row", "method", "points", "ns_a_point", "exponent"}};
        for (const TimedMethod& timed :
             timed_methods({.scan_step = step, .scan_threshold = 4 * step})) {
            double last_points = 0;
            double last_s = 0;
            for (const double points : sizes) {
                if (is_too_slow(timed, points, most_by_scan))
                    continue;
                const int count = static_cast<int>(points);
                const auto section = section_of(offset_curve(profile, count));
                const double time = trimming_s(section, timed, budget_s);
                CsvCell exponent;
                if (last_points > 0)
                    exponent = std::log(time / last_s) / std::log(points / last_points);
                result.add_row({timed.label + ", " + std::to_string(count), timed.label,
                                static_cast<std::int64_t>(count), 1e9 * time / points,
                                exponent});
                last_points = points;
                last_s = time;
            }
        }
        run.write_result(result);
    });
}
