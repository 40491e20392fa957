// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "endmill/files/csv.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"

namespace endmill {

/// The rows and columns of [KimChoi, tables 1 and 2]: the chord tolerances and the
/// diameters of the ball, in mm. Each combination is run along u and along v.
inline constexpr std::array<double, 3> table_tolerances_mm{1, 0.5, 0.2};
inline constexpr std::array<double, 3> table_diameters_mm{10, 15, 20};  ///< see above
inline constexpr std::array<Parameter, 2> table_directions{Parameter::U,
                                                           Parameter::V};  ///< see above

/// Which table.
enum class TableQuantity {
    Ncl,  ///< table 1: CL points
    Tcd,  ///< table 2: total cutter travel, mm
};
inline constexpr std::array<TableQuantity, 2> table_quantities{
    TableQuantity::Ncl, TableQuantity::Tcd};  ///< both tables

/// The cells of both tables: points and travel of the 18 runs.
struct EconomyTables {
    /// By direction (u, v), tolerance and diameter.
    std::array<std::array<std::array<DirectionCost, 3>, 3>, 2> runs{};

    /// The cell of one table. \pre tolerance and diameter are 0, 1 or 2.
    double cell(TableQuantity quantity, Parameter direction, int tolerance,
                int diameter) const;

    /// (max - min) / max of the two directions' cells.
    /// Source: [KimChoi, heads of the tables].
    double reduction_between_directions(TableQuantity quantity, int tolerance,
                                        int diameter) const;

    /// By how much the largest ball lowers the smallest one's cell, as a share.
    double reduction_by_diameter(TableQuantity quantity, Parameter direction,
                                 int tolerance) const;
};

/// What the paper leaves open, as a set of choices for all 18 runs.
struct TablePolicies {
    IsoParametricOptions plan;  ///< direction, tolerance and scallop are each run's
    double scallop_per_tolerance = 1;  ///< h / delta
    bool count_links = true;           ///< whether the travel includes the links
    bool measure_tips = false;         ///< travel of tips instead of contacts
};

/// One of the 18 runs as planned on `surface`.
IsoParametricPlan table_plan(const Surface& surface, const TablePolicies& policies,
                             Parameter direction, double tolerance_mm,
                             double diameter_mm);

/// Points and travel of `path` as `policies` count them.
DirectionCost path_cost(const ToolPath& path, const TablePolicies& policies);

/// All 18 runs on `surface`.
EconomyTables planned_tables(const Surface& surface, const TablePolicies& policies = {});

/// The 36 printed cells, from the published.csv of both tables' experiments.
EconomyTables printed_tables();

/// "NAME d=TOLERANCE u" or "… v": the label of a table's row.
std::string table_row_label(const std::string& name, double tolerance_mm,
                            Parameter direction);

/// Tables by name: "print", then `names` of surfaces in datasets/surfaces, as planned.
std::vector<std::pair<std::string, EconomyTables>> print_and_nets(
    std::span<const std::string> names, const TablePolicies& policies = {});

/// One of the two tables for each of `tables`, laid out as printed, with the reductions
/// in percent: between u and v and from the smallest to the largest ball.
CsvTable economy_csv(std::span<const std::pair<std::string, EconomyTables>> tables,
                     TableQuantity quantity);

}  // namespace endmill
