// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 2, 5 and 6 of Kang & Suh: the feasible tool motion of machines with 3, 4 and 5
// axes, also with one axis not limited.
//
//   five-axis-setup-feasible-motion OUTPUT_FOLDER
//
// Deterministic, under 0.2 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include "endmill/core/angle.h"
#include "endmill/figures/direction_figures.h"
#include "endmill/machine/configuration.h"
#include "endmill/visibility/sphere_grid.h"
#include "five-axis-setup/feasible-motion/motion_shape.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

constexpr double border_step = 0.01;  // rad

RotaryRange range(double from_deg, double to_deg)
{
    return {Angle::degrees(from_deg).radians(), Angle::degrees(to_deg).radians()};
}

void add_edges(CsvTable& edges, const std::string& row, const FeasibleDirections& set)
{
    std::int64_t number = 0;
    for (const DirectionCurve& curve : set.border(border_step)) {
        ++number;
        for (const Vec3& direction : curve)
            edges.add_row({row, number, direction.x(), direction.y(), direction.z()});
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-setup/feasible-motion";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        const auto rows = run.texts("rows");
        const auto words = run.texts("machines");
        const auto from_phi = run.numbers("phi_from_deg");
        const auto to_phi = run.numbers("phi_to_deg");
        const auto from_theta = run.numbers("theta_from_deg");
        const auto to_theta = run.numbers("theta_to_deg");
        const auto files = run.texts("files");
        const auto titles = run.texts("titles");
        const auto cells = sphere_grid(run.text("grid")).centres;
        std::vector<std::string> columns{"row"};
        for (const std::string& column : motion_columns())
            columns.push_back(column);
        CsvTable result{columns};
        CsvTable edges{{"row", "edge", "x", "y", "z"}};
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const MachineConfiguration machine = configuration_from_word(words.at(k));
            const FeasibleDirections set =
                feasible_directions(machine, {range(from_phi.at(k), to_phi.at(k)),
                                              range(from_theta.at(k), to_theta.at(k))});
            add_named(result, rows[k], motion_cells(machine, set, border_step, cells));
            add_edges(edges, rows[k], set);
            if (!files.at(k).empty())
                run.write(files[k],
                          direction_sphere_svg(set, titles.at(k), "edge of the set"));
        }
        run.write_result(result);
        run.write("edges.csv", edges.text());
    });
}
