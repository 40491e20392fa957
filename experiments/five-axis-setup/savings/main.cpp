// SPDX-License-Identifier: GPL-3.0-or-later
// Savings by the groups and nearest cells of Kang & Suh on the teapot, and the sizes of
// the cones for the teapot and for other tessellations of it.
//
//   five-axis-setup-savings OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <cmath>

#include "endmill/visibility/detail/offset_start_map.h"
#include "five-axis-setup/savings/necked_recess.h"
#include "five-axis-setup/savings/tables.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/teapot_tessellations.h"

using namespace endmill;

namespace {

std::string tessellation(int squares, bool has_bottom)
{
    const std::string along = std::to_string(squares);
    return along + " by " + along + " squares, " +
           (has_bottom ? "whole" : "without bottom");
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/savings", [](Experiment& run) {
        CsvTable result{{"row", "facets", "empty_cones", "accessible_entries",
                         "group_1_percent", "group_2_mean", "nearest_cells_mean",
                         "left_by_best_direction", "ca_paper_area_deg2",
                         "blocked_percent", "change_with_group_1"}};
        const TriangleMesh teapot = dataset_mesh(run.text("mesh"));
        const std::string grid = run.text("grid");
        const double start = run.number("offset_start");
        for (const double incidence : run.numbers("incidences_deg")) {
            const auto add = [&](const std::string& row, const StudiedPart& part,
                                 const NamedCells& more) {
                add_named(result, row + ", " + std::to_string(std::lround(incidence)),
                          joined(joined(cone_cells(part), saving_cells(part)), more));
            };
            const Angle angle = Angle::degrees(incidence);
            const StudiedPart local =
                studied_part(teapot, grid, angle, VisibilityKind::Local);
            StudiedPart part = studied_part(teapot, grid, angle);
            NamedCells more = blocked_cells(part, local);
            if (incidence == 90)
                more = joined(more, group_1_cells(part));
            add("global", part, more);
            part.visibility.map =
                offset_start_map(teapot, part.grid.centres, angle, start);
            add("global, offset start", part, {});
            add("local", local, {});
        }
        for (const double along : run.numbers("squares_a_patch"))
            for (const bool has_bottom : {true, false}) {
                const int squares = static_cast<int>(along);
                const TriangleMesh mesh = teapot_of_squares(squares + 1, has_bottom);
                add_named(result, tessellation(squares, has_bottom),
                          cone_cells(studied_part(mesh, grid, Angle::degrees(90))));
            }
        add_named(result, "recess with a neck",
                  cone_cells(studied_part(necked_recess(), grid, Angle::degrees(90))));
        run.write_result(result);
    });
}
