// SPDX-License-Identifier: GPL-3.0-or-later
// The search over whole cones on convex parts, where the optimum is known: the shortest
// great arc between two cells that together see every face.
//
//   five-axis-setup-convex-parts OUTPUT_FOLDER
//
// Deterministic, under a minute. Columns and verdicts: README.md beside this.

#include <algorithm>

#include "endmill/setup/whole_cone_search.h"
#include "endmill/visibility/detail/convex_part.h"
#include "support/experiment.h"
#include "support/setup_cells.h"

using namespace endmill;

namespace {

double degrees(double angle)
{
    return Angle::radians(angle).degrees();
}

NamedCells search_cells(const VisibilityMap& map, const SphereGrid& grid,
                        const std::string& family, double gap, double sphere_arc)
{
    WholeConeSearchOptions options;
    options.family = family_of_word(family);
    options.gap = gap;
    const WholeConeSearchResult found = whole_cone_search(grid, map, options);
    const double arc = shortest_arc_of_two(map, grid);
    const double least = options.floor_rad * (options.floor_rad + arc);
    const double excess =
        std::max(found.lower_bound / least, least / found.lower_bound / (1 + gap)) - 1;
    return {{"grid_arc_deg", degrees(arc)},
            {"arc_loss_deg", degrees(arc - sphere_arc)},
            {"floored_area_deg2", square_degrees(least)},
            {"set", square_degrees(found.objective)},
            {"above_relative", found.objective / least - 1},
            {"lower_bound", square_degrees(found.lower_bound)},
            {"is_proved", word(excess <= 1e-12)},  // to rounding
            {"width_deg", degrees(found.ranges.width)},
            {"height_deg", degrees(found.ranges.height())}};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "five-axis-setup/convex-parts", [](Experiment& run) {
            CsvTable result{{"row", "sphere_arc_deg", "grid_arc_deg", "arc_loss_deg",
                             "floored_area_deg2", "set", "above_relative", "lower_bound",
                             "is_proved", "width_deg", "height_deg"}};
            const auto parts = run.texts("parts");
            const auto incidences = run.numbers("incidences_deg");
            const auto families = run.texts("families");
            const double gap = run.number("gap");
            for (const std::string& name : run.texts("grids")) {
                const SphereGrid grid = sphere_grid(name);
                for (std::size_t k = 0; k < parts.size(); ++k) {
                    const ConvexPart part =
                        convex_part(parts[k], Angle::degrees(incidences.at(k)));
                    const VisibilityMap map = cap_map(part, grid);
                    const NamedCells sphere{
                        {"sphere_arc_deg", part.shortest_arc.degrees()}};
                    for (const std::string& family : families) {
                        std::string row = name;
                        row.append(", ").append(parts[k]).append(", ").append(family);
                        add_named(
                            result, row,
                            joined(sphere, search_cells(map, grid, family, gap,
                                                        part.shortest_arc.radians())));
                    }
                }
            }
            run.write_result(result);
        });
}
