// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of the nearest-cell approximation of Kang & Suh: its least area against the
// certified optimum over whole cones; and the reach of machines with fewer axes on the
// teapot.
//
//   five-axis-setup-modes OUTPUT_FOLDER
//
// Deterministic, about a minute. Columns and verdicts: README.md beside this.

#include <cmath>

#include "five-axis-setup/modes/fewer_axes.h"
#include "five-axis-setup/modes/tables.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

CsvTable table()
{
    std::vector<std::string> columns{"row"};
    for (const std::string& column : mode_columns())
        columns.push_back(column);
    for (const char* column : {"arc_deg", "cells", "facets_left", "setups"})
        columns.emplace_back(column);
    return CsvTable{columns};
}

std::string row_name(std::string family, const std::string& at,
                     const std::string& objective)
{
    return family.append(at).append(", ").append(objective);
}

// Machines with three axes, and with four, also about the line from handle to spout.
void add_fewer_axes(CsvTable& result, const std::string& at, const StudiedPart& part,
                    Experiment& run)
{
    const std::string about_x = "4 axes about x" + at;
    add_named(result, "3 axes" + at,
              three_axes_cells(part, static_cast<int>(run.number("most_setups"))));
    add_named(result, "4 axes" + at,
              best_four_axes_cells(part, sphere_grid(run.text("axes")),
                                   Angle::degrees(run.number("arc_tolerance_deg"))));
    add_named(result, about_x, four_axes_cells(part, Vec3::UnitX()));
    for (const double reach_deg : run.numbers("reaches_deg"))
        add_named(
            result, about_x + ", within " + std::to_string(std::lround(reach_deg)),
            reach_cells(part, cells_on_circle(part.grid, Vec3::UnitX(), Vec3::UnitZ(),
                                              Angle::degrees(reach_deg))));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/modes", [](Experiment& run) {
        CsvTable result = table();
        const TriangleMesh teapot = dataset_mesh(run.text("mesh"));
        const std::string grid = run.text("grid");
        const auto families = run.texts("families");
        const auto objectives = run.texts("objectives");
        const double gap = run.number("gap");
        for (const double incidence : run.numbers("incidences_deg")) {
            const StudiedPart part =
                studied_part(teapot, grid, Angle::degrees(incidence));
            const std::string at = ", " + std::to_string(std::lround(incidence));
            for (const std::string& family : families)
                for (const std::string& objective : objectives)
                    add_named(result, row_name(family, at, objective),
                              mode_cells(part, {family, objective, gap}));
            add_fewer_axes(result, at, part, run);
        }
        run.write_result(result);
    });
}
