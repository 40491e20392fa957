// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/printed_tables.h"

#include <algorithm>
#include <cstdint>

#include "endmill/core/text.h"
#include "support/experiment.h"

namespace endmill {
namespace {

// The rows of published.csv under which the printed cells stand.
const char* const printed_rows = "net_rot24_7D";

int index(Parameter direction)
{
    return direction == Parameter::U ? 0 : 1;
}

std::string cell_column(TableQuantity quantity, double diameter_mm)
{
    return quantity == TableQuantity::Ncl ? "ncl_d" + to_text(diameter_mm)
                                          : "tcd_d" + to_text(diameter_mm) + "_mm";
}

double reduction(double one, double other)
{
    return (std::max(one, other) - std::min(one, other)) / std::max(one, other);
}

CsvCell cell_of(TableQuantity quantity, double value)
{
    if (quantity == TableQuantity::Ncl)
        return static_cast<std::int64_t>(value);
    return value;
}

std::vector<std::string> csv_columns(TableQuantity quantity)
{
    std::vector<std::string> columns{"row"};
    for (const double diameter : table_diameters_mm)
        columns.push_back(cell_column(quantity, diameter));
    for (const double diameter : table_diameters_mm)
        columns.push_back("reduction_u_v_d" + to_text(diameter) + "_percent");
    columns.emplace_back("reduction_d10_d20_percent");
    return columns;
}

struct RowPlace {
    TableQuantity quantity;
    Parameter direction;
    int tolerance;
};

std::vector<CsvCell> csv_row(const std::string& label, const EconomyTables& table,
                             const RowPlace& place)
{
    const auto [quantity, direction, i] = place;
    std::vector<CsvCell> cells{label};
    for (int j = 0; j < 3; ++j)
        cells.push_back(cell_of(quantity, table.cell(quantity, direction, i, j)));
    for (int j = 0; j < 3; ++j)
        if (direction == Parameter::V)  // as printed: once for both rows
            cells.emplace_back(100 * table.reduction_between_directions(quantity, i, j));
        else
            cells.emplace_back();
    cells.emplace_back(100 * table.reduction_by_diameter(quantity, direction, i));
    return cells;
}

}  // namespace

double EconomyTables::cell(TableQuantity quantity, Parameter direction, int tolerance,
                           int diameter) const
{
    const DirectionCost& cost = runs[index(direction)][tolerance][diameter];
    return quantity == TableQuantity::Ncl ? static_cast<double>(cost.ncl) : cost.tcd_mm;
}

double EconomyTables::reduction_between_directions(TableQuantity quantity, int tolerance,
                                                   int diameter) const
{
    return reduction(cell(quantity, Parameter::U, tolerance, diameter),
                     cell(quantity, Parameter::V, tolerance, diameter));
}

double EconomyTables::reduction_by_diameter(TableQuantity quantity, Parameter direction,
                                            int tolerance) const
{
    const double smallest = cell(quantity, direction, tolerance, 0);
    return (smallest - cell(quantity, direction, tolerance, 2)) / smallest;
}

IsoParametricPlan table_plan(const Surface& surface, const TablePolicies& policies,
                             Parameter direction, double tolerance_mm, double diameter_mm)
{
    IsoParametricOptions options = policies.plan;
    options.direction = direction;
    options.chord_tolerance = tolerance_mm;
    options.scallop_height = policies.scallop_per_tolerance * tolerance_mm;
    return plan_iso_parametric(surface, BallCutter{diameter_mm / 2}, options);
}

DirectionCost path_cost(const ToolPath& path, const TablePolicies& policies)
{
    const PathEconomy economy = path_economy(path);
    const auto length = [&](const Travel& travel) {
        return policies.measure_tips ? travel.tip_mm : travel.contact_mm;
    };
    const double links = policies.count_links ? length(economy.link) : 0;
    return {economy.ncl, length(economy.cut) + links};
}

EconomyTables planned_tables(const Surface& surface, const TablePolicies& policies)
{
    EconomyTables tables;
    for (const Parameter direction : table_directions)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                tables.runs[index(direction)][i][j] =
                    path_cost(table_plan(surface, policies, direction,
                                         table_tolerances_mm[i], table_diameters_mm[j])
                                  .path,
                              policies);
    return tables;
}

EconomyTables printed_tables()
{
    const auto printed = [](TableQuantity quantity, const std::string& row,
                            double diameter) {
        const bool points = quantity == TableQuantity::Ncl;
        return published_number(
            points ? "economic-cl-data/table-1" : "economic-cl-data/table-2", row,
            cell_column(quantity, diameter));
    };
    EconomyTables tables;
    for (const Parameter direction : table_directions)
        for (int i = 0; i < 3; ++i) {
            const std::string row =
                table_row_label(printed_rows, table_tolerances_mm[i], direction);
            for (int j = 0; j < 3; ++j) {
                const double diameter = table_diameters_mm[j];
                const double ncl = printed(TableQuantity::Ncl, row, diameter);
                tables.runs[index(direction)][i][j] = {
                    static_cast<std::size_t>(ncl),
                    printed(TableQuantity::Tcd, row, diameter)};
            }
        }
    return tables;
}

std::string table_row_label(const std::string& name, double tolerance_mm,
                            Parameter direction)
{
    return name + " d=" + to_text(tolerance_mm) +
           (direction == Parameter::U ? " u" : " v");
}

std::vector<std::pair<std::string, EconomyTables>> print_and_nets(
    std::span<const std::string> names, const TablePolicies& policies)
{
    std::vector<std::pair<std::string, EconomyTables>> tables{
        {"print", printed_tables()}};
    for (const std::string& name : names)
        tables.emplace_back(name, planned_tables(dataset_surface(name), policies));
    return tables;
}

CsvTable economy_csv(std::span<const std::pair<std::string, EconomyTables>> tables,
                     TableQuantity quantity)
{
    CsvTable csv{csv_columns(quantity)};
    for (const auto& [name, table] : tables)
        for (int i = 0; i < 3; ++i)
            for (const Parameter direction : table_directions) {
                const RowPlace place{quantity, direction, i};
                csv.add_row(
                    csv_row(table_row_label(name, table_tolerances_mm[i], direction),
                            table, place));
            }
    return csv;
}

}  // namespace endmill
