// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 11 and 12 of Kang & Suh in numbers: the best setups of the teapot by the
// paper's algorithms and by their corrected form, on grids of about 1200 cells.
//
//   five-axis-setup-teapot-grids OUTPUT_FOLDER
//
// Deterministic, about 5 s. Columns and verdicts: README.md beside this.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "five-axis-setup/teapot-grids/comparisons.h"
#include "five-axis-setup/teapot-grids/tables.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

CsvTable table()
{
    std::vector<std::string> columns{"row"};
    for (const std::string& column : search_columns())
        columns.push_back(column);
    columns.emplace_back("change_relative");
    for (const std::string& column : comparison_columns())
        columns.push_back(column);
    return CsvTable{columns};
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-setup/teapot-grids";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        CsvTable result = table();
        const TriangleMesh teapot = dataset_mesh(run.text("mesh"));
        const auto searches = named_searches(run.texts("families"), run.texts("modes"));
        const auto grids = run.texts("grids");
        const auto incidences = run.numbers("incidences_deg");
        std::vector<GridSetups> compared;
        for (std::size_t k = 0; k < grids.size(); ++k) {
            GridSetups one{
                studied_part(teapot, grids[k], Angle::degrees(incidences.at(k))), {}};
            one.setups = found_setups(one.part, searches);
            const std::string row =
                grids[k] + ", " + std::to_string(std::lround(incidences[k])) + ", ";
            for (const FoundSetup& setup : one.setups)
                add_named(result, row + setup.search.label(),
                          search_cells(one.part, one.setups, setup));
            if (incidences[k] == 90)
                compared.push_back(std::move(one));
        }
        for (const std::string& family : run.texts("families")) {
            for (const char* mode : {"paper-literal", "paper"})
                add_named(result, "six grids, 90, " + family + ", " + mode,
                          spread_cells(compared, family, mode));
            add_named(result, "four grids of 1200, 90, " + family + ", paper",
                      agreement_cells(compared, family, 1200));
        }
        add_named(result, "a machine A,B that suffices, paper",
                  machine_cells(compared.front().part, run.numbers("machine_r1_deg"),
                                run.numbers("machine_r2_deg")));

        const std::string grid = run.text("symmetric_grid");
        const StudiedPart part = studied_part(teapot, grid, Angle::degrees(90));
        const auto add_moved = [&](const std::string& row,
                                   const Eigen::Matrix3d& motion) {
            const StudiedPart other =
                studied_part(moved(teapot, motion), grid, Angle::degrees(90));
            for (const NamedSearch& search : searches)
                add_named(result, row + search.label(), moved_cells(part, other, search));
        };
        add_moved("mirrored in y, ", Vec3{1, -1, 1}.asDiagonal());
        const Eigen::AngleAxisd turn{std::numbers::pi / 3, Vec3::UnitZ()};
        add_moved("turned by 60 about z, ", turn.toRotationMatrix());
        run.write_result(result);
    });
}
