// SPDX-License-Identifier: GPL-3.0-or-later
// Scaling of the tables: exponents of points and travel in tolerance and ball radius, for
// the printed cells and for the fitted nets.
//
//   economic-cl-data-exponents OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns: README.md beside this.

#include "endmill/planning/detail/economy_scaling.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/printed_tables.h"

using namespace endmill;

namespace {

// Whether points and travel rise in all rows as the tolerance falls.
bool rises_with_accuracy(const EconomyTables& tables)
{
    for (const TableQuantity quantity : table_quantities)
        for (const Parameter direction : table_directions)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 2; ++i)
                    if (tables.cell(quantity, direction, i + 1, j) <=
                        tables.cell(quantity, direction, i, j))
                        return false;
    return true;
}

void add_laws(CsvTable& result, const std::string& name, const EconomyTables& tables)
{
    const ValueRange by_diameter = reductions_by_diameter(tables);
    for (const Parameter direction : table_directions) {
        const ScalingLaw points = scaling_law(tables, TableQuantity::Ncl, direction);
        const ScalingLaw travel = scaling_law(tables, TableQuantity::Tcd, direction);
        const ValueRange equal = travel_times_plane_interval(tables, direction, 1);
        const ValueRange half = travel_times_plane_interval(tables, direction, 0.5);
        result.add_row(
            {name + (direction == Parameter::U ? " u" : " v"), travel.tolerance_exponent,
             points.tolerance_exponent, travel.diameter_exponent,
             points.diameter_exponent, 100 * travel.worst_residual,
             100 * points.worst_residual, 100 * by_diameter.least,
             100 * by_diameter.greatest, 100 * segment_spread(tables), equal.least,
             equal.greatest, half.least, half.greatest,
             word(rises_with_accuracy(tables) && falls_with_diameter(tables))});
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/exponents", [](Experiment& run) {
        CsvTable result{{"row", "tcd_by_tolerance", "ncl_by_tolerance", "tcd_by_radius",
                         "ncl_by_radius", "tcd_residual_percent", "ncl_residual_percent",
                         "reduction_d10_d20_least_percent",
                         "reduction_d10_d20_greatest_percent", "segment_spread_percent",
                         "travel_interval_least_mm2", "travel_interval_greatest_mm2",
                         "travel_interval_half_scallop_least_mm2",
                         "travel_interval_half_scallop_greatest_mm2", "varies"}};
        for (const auto& [name, tables] : print_and_nets(run.texts("surfaces")))
            add_laws(result, name, tables);
        run.write_result(result);
    });
}
