// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the exact envelope of a section, with the bars and the times of CGAL and
// polyclipping.
//
//   benchmarks-envelope OUTPUT_FOLDER
//
// About 60 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <limits>

#include "benchmarks/envelope/baselines.h"
#include "benchmarks/envelope/raw_chain.h"
#include "endmill/trimming/detail/envelope_trimming.h"
#include "support/cpu_time.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// Time of the best of `repeats` executions.
template <typename Work>
double shortest_s(int repeats, const Work& work)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < repeats; ++k) {
        const double begin = thread_cpu_s();
        work();
        shortest = std::min(shortest, thread_cpu_s() - begin);
    }
    return shortest;
}

double envelope_s(int repeats, const SectionCurve& curve)
{
    return shortest_s(repeats, [&] { return envelope_trimming({&curve, 1}); });
}

// Uses the orientation with the shorter chain; the other one takes minutes.
double polyclipping_s(const SectionCurve& chain, const SectionCurve& shorter)
{
    constexpr double depth = 1e3;
    const auto upright = [&](const SectionCurve& curve) {
        return shortest_s(1, [&] { polyclipping_union(curve, {0, -depth}); });
    };
    const auto on_end = [&](const SectionCurve& curve) {
        return shortest_s(1, [&] { polyclipping_union(turned(curve), {depth, 0}); });
    };
    return upright(shorter) < on_end(shorter) ? upright(chain) : on_end(chain);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/envelope", [](Experiment& run) {
        const auto segments = static_cast<std::size_t>(run.number("segments"));
        const int repeats = static_cast<int>(run.number("repeats"));
        const double noise_mm = run.number("noise_mm");
        CsvTable result{{"row", "measured", "unit", "bar_at_most", "bar_at_least"}};
        for (const bool is_noisy : {false, true}) {
            const std::string name = is_noisy ? "noisy" : "smooth";
            const double noise = is_noisy ? noise_mm : 0;
            const SectionCurve chain = raw_chain(segments, noise);
            const SectionCurve on_end = turned(chain);
            const SectionCurve shorter = raw_chain(segments / 10, noise);
            const double time = envelope_s(repeats, chain);
            const double time_turned = envelope_s(repeats, on_end);
            const double time_shorter = envelope_s(10 * repeats, shorter);
            const double cgal = shortest_s(1, [&] { return cgal_envelope(chain); });
            const double clipped = polyclipping_s(chain, shorter);
            const double ns = 1e9 / static_cast<double>(segments);
            result.add_row({name, ns * time, "ns a segment", is_noisy ? 65 : 50, {}});
            result.add_row(
                {name + ", turned", time_turned / time, "of unturned", 1.3, {}});
            result.add_row(
                {name + ", ten times as long", time / time_shorter, "times", 12.5, {}});
            result.add_row(
                {name + ", CGAL", cgal / time, "times ours", {}, is_noisy ? 80 : 50});
            result.add_row(
                {name + ", polyclipping", clipped / time, "times ours", {}, 5});
        }
        run.write_result(result);
    });
}
