// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/economy_scaling.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "endmill/planning/path_interval.h"

namespace endmill {
namespace {

constexpr ValueRange nothing_yet{std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};

void include(ValueRange& range, double value)
{
    range.least = std::min(range.least, value);
    range.greatest = std::max(range.greatest, value);
}

// Calls `visit` for each of the nine cells of a direction.
void for_cells(const std::function<void(int tolerance, int diameter)>& visit)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            visit(i, j);
}

// Least-squares slope of y over x. The nine cells form a full factorial design, so the
// fit of one exponent does not depend on the other variable.
double slope(const std::array<double, 9>& x, const std::array<double, 9>& y)
{
    double mean_x = 0;
    double mean_y = 0;
    for (int k = 0; k < 9; ++k) {
        mean_x += x[k] / 9;
        mean_y += y[k] / 9;
    }
    double xy = 0;
    double xx = 0;
    for (int k = 0; k < 9; ++k) {
        xy += (x[k] - mean_x) * (y[k] - mean_y);
        xx += (x[k] - mean_x) * (x[k] - mean_x);
    }
    return xy / xx;
}

}  // namespace

ScalingLaw scaling_law(const EconomyTables& tables, TableQuantity quantity,
                       Parameter direction)
{
    std::array<double, 9> tolerance;
    std::array<double, 9> diameter;
    std::array<double, 9> value;
    for_cells([&](int i, int j) {
        tolerance[3 * i + j] = std::log(table_tolerances_mm[i]);
        diameter[3 * i + j] = std::log(table_diameters_mm[j]);
        value[3 * i + j] = std::log(tables.cell(quantity, direction, i, j));
    });
    ScalingLaw law{slope(tolerance, value), slope(diameter, value), 0};
    double constant = 0;
    std::array<double, 9> rest;
    for (int k = 0; k < 9; ++k) {
        rest[k] = value[k] - law.tolerance_exponent * tolerance[k] -
                  law.diameter_exponent * diameter[k];
        constant += rest[k] / 9;
    }
    for (const double log_value : rest)
        law.worst_residual =
            std::max(law.worst_residual, std::abs(std::expm1(constant - log_value)));
    return law;
}

ValueRange reductions_by_diameter(const EconomyTables& tables)
{
    ValueRange range = nothing_yet;
    for (const TableQuantity quantity : table_quantities)
        for (const Parameter direction : table_directions)
            for (int i = 0; i < 3; ++i)
                include(range, tables.reduction_by_diameter(quantity, direction, i));
    return range;
}

ValueRange reductions_between_directions(const EconomyTables& tables,
                                         TableQuantity quantity)
{
    ValueRange range = nothing_yet;
    for_cells([&](int i, int j) {
        include(range, tables.reduction_between_directions(quantity, i, j));
    });
    return range;
}

double segment_spread(const EconomyTables& tables)
{
    double worst = 0;
    for (const Parameter direction : table_directions)
        for (int i = 0; i < 3; ++i) {
            ValueRange range = nothing_yet;
            double mean = 0;
            for (int j = 0; j < 3; ++j) {
                const double segment = tables.cell(TableQuantity::Tcd, direction, i, j) /
                                       tables.cell(TableQuantity::Ncl, direction, i, j);
                include(range, segment);
                mean += segment / 3;
            }
            worst = std::max(worst, (range.greatest - range.least) / mean);
        }
    return worst;
}

ValueRange travel_times_plane_interval(const EconomyTables& tables, Parameter direction,
                                       double scallop_per_tolerance)
{
    ValueRange range = nothing_yet;
    for_cells([&](int i, int j) {
        const double h = scallop_per_tolerance * table_tolerances_mm[i];
        const BallCutter ball{table_diameters_mm[j] / 2};
        include(range, tables.cell(TableQuantity::Tcd, direction, i, j) *
                           path_interval(ball, 0, h).chord);
    });
    return range;
}

bool falls_with_diameter(const EconomyTables& tables)
{
    bool falls = true;
    for (const TableQuantity quantity : table_quantities)
        for (const Parameter direction : table_directions)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 2; ++j)
                    falls = falls && tables.cell(quantity, direction, i, j + 1) <
                                         tables.cell(quantity, direction, i, j);
    return falls;
}

bool v_beats_u(const EconomyTables& tables)
{
    bool beats = true;
    for (const TableQuantity quantity : table_quantities)
        for_cells([&](int i, int j) {
            beats = beats && tables.cell(quantity, Parameter::V, i, j) <
                                 tables.cell(quantity, Parameter::U, i, j);
        });
    return beats;
}

double mean_change(const EconomyTables& defaults, const EconomyTables& changed,
                   TableQuantity quantity, Parameter direction)
{
    double mean = 0;
    for_cells([&](int i, int j) {
        const double before = defaults.cell(quantity, direction, i, j);
        mean += (changed.cell(quantity, direction, i, j) - before) / before / 9;
    });
    return mean;
}

double worst_deviation(const EconomyTables& tables, const EconomyTables& reference)
{
    double worst = 0;
    for (const TableQuantity quantity : table_quantities)
        for (const Parameter direction : table_directions)
            for_cells([&](int i, int j) {
                const double wanted = reference.cell(quantity, direction, i, j);
                const double found = tables.cell(quantity, direction, i, j);
                worst = std::max(worst, std::abs(found - wanted) / wanted);
            });
    return worst;
}

}  // namespace endmill
