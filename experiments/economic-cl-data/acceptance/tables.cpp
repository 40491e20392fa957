// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/acceptance/tables.h"

#include "support/named_cells.h"

namespace endmill {
namespace {

void append_percent(std::vector<CsvCell>& cells, const ValueRange& shares)
{
    cells.emplace_back(100 * shares.least);
    cells.emplace_back(100 * shares.greatest);
}

}  // namespace

std::vector<std::string> acceptance_columns()
{
    return {"row",
            "largest_ball_mm",
            "largest_ball_u",
            "largest_ball_v",
            "tcd_by_tolerance_u",
            "tcd_by_tolerance_v",
            "ncl_by_tolerance_u",
            "ncl_by_tolerance_v",
            "ncl_by_radius_u",
            "ncl_by_radius_v",
            "tcd_by_radius_u",
            "tcd_by_radius_v",
            "reduction_d10_d20_least_percent",
            "reduction_d10_d20_greatest_percent",
            "segment_spread_percent",
            "worst_cell_percent",
            "ncl_reduction_least_percent",
            "ncl_reduction_greatest_percent",
            "tcd_reduction_least_percent",
            "tcd_reduction_greatest_percent",
            "cusp_least_share",
            "cusp_greatest_share",
            "cusp_median_off_percent",
            "item_1",
            "item_2",
            "item_3",
            "item_4",
            "item_5",
            "item_6",
            "item_8",
            "admits_d20"};
}

std::vector<CsvCell> acceptance_row(const std::string& name, const Acceptance& found,
                                    const EconomyTables& printed)
{
    const EconomyTables& tables = found.tables;
    std::vector<CsvCell> cells{name, found.limit.radius_mm, found.limit.at.u,
                               found.limit.at.v};
    for (const TableQuantity quantity : {TableQuantity::Tcd, TableQuantity::Ncl})
        for (const Parameter direction : table_directions)
            cells.emplace_back(
                scaling_law(tables, quantity, direction).tolerance_exponent);
    for (const TableQuantity quantity : table_quantities)
        for (const Parameter direction : table_directions)
            cells.emplace_back(
                scaling_law(tables, quantity, direction).diameter_exponent);
    append_percent(cells, reductions_by_diameter(tables));
    cells.emplace_back(100 * segment_spread(tables));
    cells.emplace_back(100 * worst_deviation(tables, printed));
    for (const TableQuantity quantity : table_quantities)
        append_percent(cells, reductions_between_directions(tables, quantity));
    cells.emplace_back(found.cusps.pairs.least);
    cells.emplace_back(found.cusps.pairs.greatest);
    cells.emplace_back(100 * found.cusps.worst_median);
    for (const bool holds :
         {found.travel_falls_with_root_of_tolerance(), found.points_fall_with_tolerance(),
          found.both_fall_with_root_of_radius(), found.doubling_the_ball_saves(),
          found.segments_depend_on_tolerance_only(), found.cells_are_near(printed),
          found.cusps_are_as_asked()})
        cells.emplace_back(std::string{holds ? "holds" : "outside"});
    cells.push_back(word(found.limit.radius_mm > table_diameters_mm.back() / 2));
    return cells;
}

}  // namespace endmill
