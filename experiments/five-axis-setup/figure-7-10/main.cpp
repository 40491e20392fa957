// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 7 to 10 of Kang & Suh: azimuths and polar angles, the double sector, the hull and the
// rectangle of small sets of directions about a fixed tool axis.
//
//   five-axis-setup-figure-7-10 OUTPUT_FOLDER
//
// Deterministic, under 0.5 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include "endmill/setup/detail/rectangle_fit.h"
#include "endmill/setup/detail/spherical_hull.h"
#include "support/candidate_tables.h"
#include "support/experiment.h"
#include "support/setup_cells.h"

using namespace endmill;

namespace {

void add_sectors(Experiment& run, CsvTable& table, const std::string& row,
                 const std::string& title, const DirectionSet& set)
{
    const auto paper = sector_candidates(set.tool_axis, set.directions, SetupMode::Paper);
    const auto all =
        sector_candidates(set.tool_axis, set.directions, SetupMode::Corrected);
    table.add_row({row,
                   "C,A",
                   static_cast<std::int64_t>(paper.size()),
                   static_cast<std::int64_t>(all.size()),
                   square_degrees(least_area(paper).area()),
                   square_degrees(least_area(all).area()),
                   {}});
    run.write(row + "-sectors.svg", sector_chart(title, set, least_area(paper)));
}

void add_rectangles(Experiment& run, CsvTable& table, const std::string& row,
                    const std::string& title, const DirectionSet& set)
{
    const auto paper =
        rectangle_candidates(set.tool_axis, set.directions, SetupMode::Paper);
    const auto all =
        rectangle_candidates(set.tool_axis, set.directions, SetupMode::Corrected);
    const auto hull =
        spherical_hull(set.tool_axis, set.directions, HullProjection::Gnomonic);
    table.add_row(
        {row, "A,B", static_cast<std::int64_t>(paper.size()),
         static_cast<std::int64_t>(all.size()), square_degrees(least_area(paper).area()),
         square_degrees(least_area(all).area()), static_cast<std::int64_t>(hull.size())});
    run.write(row + "-rectangle.svg", rectangle_chart(title, set, least_area(all)));
    run.write(row + "-hull.svg", hull_chart(title, set, ChartProjection::Gnomonic));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/figure-7-10", [](Experiment& run) {
        CsvTable table{{"row", "family", "paper_candidates", "candidates",
                        "paper_area_deg2", "area_deg2", "hull_vertices"}};
        const auto rows = run.texts("rows");
        const auto families = run.texts("families");
        const auto sets = run.texts("directions_deg");
        const auto titles = run.texts("titles");
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (families.at(k) == "C,A")
                add_sectors(run, table, rows[k], titles.at(k), direction_set(sets.at(k)));
            else
                add_rectangles(run, table, rows[k], titles.at(k),
                               direction_set(sets.at(k)));
        run.write_result(table);
    });
}
