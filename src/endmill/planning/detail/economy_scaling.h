// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/planning/detail/economy_tables.h"

namespace endmill {

/// Power law of a quantity in one direction: the least-squares fit of
/// log(cell) = constant + tolerance_exponent log(delta) + diameter_exponent log(D) to its
/// nine cells.
struct ScalingLaw {
    double tolerance_exponent;
    double diameter_exponent;
    double worst_residual;  ///< largest |fit - cell| / cell
};

/// Fits the power law to the nine cells of one quantity and direction.
ScalingLaw scaling_law(const EconomyTables& tables, TableQuantity quantity,
                       Parameter direction);

/// Least and greatest of a set of values.
struct ValueRange {
    double least;
    double greatest;
};

/// Range of EconomyTables::reduction_by_diameter over the twelve rows of both tables.
ValueRange reductions_by_diameter(const EconomyTables& tables);

/// Range of EconomyTables::reduction_between_directions over the nine cells of one table.
ValueRange reductions_between_directions(const EconomyTables& tables,
                                         TableQuantity quantity);

/// Dependence of the mean segment TCD / NCL on the diameter of the ball: the largest
/// (max - min) / mean over the three diameters, among all tolerances and directions.
double segment_spread(const EconomyTables& tables);

/// Range over the nine cells of travel times the interval on a plane, TCD 2 sqrt(2 R h -
/// h^2), in mm^2. If no interval exceeds that on a plane, each value is an upper bound on
/// the area of the part.
/// \param scallop_per_tolerance h / delta.
ValueRange travel_times_plane_interval(const EconomyTables& tables, Parameter direction,
                                       double scallop_per_tolerance);

/// Whether both quantities fall with the diameter of the ball in all six rows of each
/// table.
bool falls_with_diameter(const EconomyTables& tables);

/// Whether passes along v cost less than passes along u in all nine cells of both tables.
bool v_beats_u(const EconomyTables& tables);

/// Mean of (changed - defaults) / defaults over the nine cells of one quantity and
/// direction.
double mean_change(const EconomyTables& defaults, const EconomyTables& changed,
                   TableQuantity quantity, Parameter direction);

/// Largest |cell - reference cell| / reference cell over all cells of both tables.
double worst_deviation(const EconomyTables& tables, const EconomyTables& reference);

}  // namespace endmill
