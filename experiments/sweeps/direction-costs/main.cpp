// SPDX-License-Identifier: GPL-3.0-or-later
// CPU time that the visibility of a part takes along each direction, and its spread.
//
//   sweeps-direction-costs OUTPUT_FOLDER
//
// Measured, about 20 s alone on the machine. Columns: README.md beside this.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "benchmarks/height_parts.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
#include "support/cpu_time.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// CPU times in s of one thread: until the first direction is done, and along each other.
struct DirectionTimes {
    double start;
    std::vector<double> each;
};

DirectionTimes direction_times(const TriangleMesh& part, std::span<const Vec3> directions)
{
    DirectionTimes times{0, {}};
    VisibilityOptions options;
    double last = thread_cpu_s();
    options.progress = [&](std::size_t done) {
        const double now = thread_cpu_s();
        if (done == 1)
            times.start = now - last;
        else
            times.each.push_back(now - last);
        last = now;
    };
    part_visibility(part, directions, options);
    return times;
}

double mean_of(std::span<const double> numbers)
{
    double sum = 0;
    for (const double number : numbers)
        sum += number;
    return sum / static_cast<double>(numbers.size());
}

// Standard deviation as a share of the mean.
double spread_of(std::span<const double> numbers)
{
    const double mean = mean_of(numbers);
    double squares = 0;
    for (const double number : numbers)
        squares += (number - mean) * (number - mean);
    return std::sqrt(squares / static_cast<double>(numbers.size())) / mean;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "sweeps/direction-costs", [](Experiment& run) {
        set_thread_count(1);
        const SphereGrid grid = sphere_grid(run.text("sphere"));
        CsvTable result{{"row", "facets", "directions", "pair_ns", "direction_ms",
                         "spread", "start_ms"}};
        for (const double cells : run.numbers("cells_along_a_side")) {
            const TriangleMesh part = grid_part(static_cast<int>(cells), bumpy_height);
            const DirectionTimes times = direction_times(part, grid.centres);
            const double mean = mean_of(times.each);
            const auto facets = static_cast<std::int64_t>(part.triangles().size());
            result.add_row({std::to_string(facets) + " facets", facets,
                            static_cast<std::int64_t>(grid.centres.size()),
                            1e9 * mean / static_cast<double>(facets), 1e3 * mean,
                            spread_of(times.each), 1e3 * times.start});
        }
        run.write_result(result);
    });
}
