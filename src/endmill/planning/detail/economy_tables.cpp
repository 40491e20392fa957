// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/economy_tables.h"

#include <algorithm>

namespace endmill {
namespace {

int index(Parameter direction)
{
    return direction == Parameter::U ? 0 : 1;
}

double reduction(double one, double other)
{
    return (std::max(one, other) - std::min(one, other)) / std::max(one, other);
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
    return {economy.ncl, counted_travel(economy, policies.distance, policies.counted)};
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

}  // namespace endmill
