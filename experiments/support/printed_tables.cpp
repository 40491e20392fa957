// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/printed_tables.h"

#include <cstdint>

#include "endmill/core/text.h"
#include "support/experiment.h"

namespace endmill {
namespace {

// The published.csv of both tables has the printed cells in the rows of this surface.
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
        if (direction == Parameter::V)  // the print states it once for both rows
            cells.emplace_back(100 * table.reduction_between_directions(quantity, i, j));
        else
            cells.emplace_back();
    cells.emplace_back(100 * table.reduction_by_diameter(quantity, direction, i));
    return cells;
}

}  // namespace

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
