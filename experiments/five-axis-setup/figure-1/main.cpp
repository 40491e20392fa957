// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 1 of Kang & Suh: the visibility cones of two facets of the teapot, and all cones moved to
// one origin.
//
//   five-axis-setup-figure-1 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "endmill/figures/setup_figures.h"
#include "support/experiment.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

// The row of the map that belongs to one facet.
VisibilityMap map_of(const VisibilityMap& all, std::size_t facet)
{
    VisibilityMap one{1, all.cells()};
    for (std::size_t i = 0; i < all.cells(); ++i)
        one.column(i)[0] = all.is_accessible(facet, i) ? 1 : 0;
    return one;
}

std::int64_t entries(const VisibilityMap& map)
{
    std::int64_t count = 0;
    for (std::size_t j = 0; j < map.facets(); ++j)
        for (std::size_t i = 0; i < map.cells(); ++i)
            count += map.is_accessible(j, i) ? 1 : 0;
    return count;
}

// The azimuth from which the facet is seen from the side, turned 50 degrees towards its
// front.
Angle view_of(const TriangleMesh& mesh, std::size_t facet)
{
    const auto corners = mesh.corners(facet);
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    return Angle::radians(std::atan2(normal.y(), normal.x()) -
                          Angle::degrees(40).radians());
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/figure-1", [](Experiment& run) {
        const StudiedPart part =
            studied_part(run.text("mesh"), run.text("grid"),
                         Angle::degrees(run.number("incidence_deg")));
        const VisibilityMap& map = part.visibility.map;
        const auto fractions = visible_fractions(map, part.grid.solid_angles_sr);
        CsvTable table{{"row", "cells", "visible_fraction"}};
        for (const double number : run.numbers("facets")) {
            const auto facet = static_cast<std::size_t>(number);
            const std::string row = "facet-" + std::to_string(facet);
            const VisibilityMap cone = map_of(map, facet);
            table.add_row({row, entries(cone), fractions.at(facet)});
            const std::string title = "Facet " + std::to_string(facet);
            run.write(row + ".svg", sphere_svg(part.grid, cone, {.title = title}));
            run.write(row + "-cone.svg",
                      cone_svg(part.mesh, facet, part.grid, map,
                               {.title = title + " and its visibility cone on the part",
                                .azimuth = view_of(part.mesh, facet)}));
        }
        table.add_row({"all facets", entries(map), {}});
        run.write("map.svg", sphere_svg(part.grid, map, {.title = "All facets"}));
        run.write_result(table);
    });
}
