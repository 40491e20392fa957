// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres with about 1200 cells and their uniformity. Figure 12 of Kang & Suh is all that
// is known of their own sphere.
//
//   five-axis-setup-sphere-grids OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "endmill/visibility/detail/cover_radius.h"
#include "endmill/visibility/sphere_grid.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    const std::string name = "five-axis-setup/sphere-grids";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        CsvTable result{{"row", "cells", "area_ratio", "least_area_deg2",
                         "most_area_deg2", "cover_radius_deg"}};
        constexpr double deg = 180 / std::numbers::pi;
        for (const std::string& word : run.texts("grids")) {
            const SphereGrid grid = sphere_grid(word);
            const auto [least, most] = std::ranges::minmax(grid.solid_angles_sr);
            result.add_row({word, static_cast<std::int64_t>(grid.cells.size()),
                            most / least, least * deg * deg, most * deg * deg,
                            cover_radius(grid.centres) * deg});
        }
        run.write_result(result);
    });
}
