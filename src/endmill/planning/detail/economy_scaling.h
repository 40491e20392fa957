// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/printed_tables.h"

namespace endmill {

/// How a quantity of the tables scales in one direction: the least-squares fit of
/// log(cell) = constant + tolerance_exponent log(delta) + diameter_exponent log(D) to its
/// nine cells.
struct ScalingLaw {
    double tolerance_exponent;
    double diameter_exponent;
    double worst_residual;  ///< of the fit against a cell, as a share of the cell
};

/// The fit to the cells of one quantity and direction.
ScalingLaw scaling_law(const EconomyTables& tables, TableQuantity quantity,
                       Parameter direction);

/// A least and a greatest value.
struct ValueRange {
    double least;
    double greatest;
};

/// What the largest ball saves against the smallest, as a share, over all twelve rows of
/// both tables.
ValueRange reductions_by_diameter(const EconomyTables& tables);

/// What the cheaper direction saves, as a share, over the nine cells of a table.
ValueRange reductions_between_directions(const EconomyTables& tables,
                                         TableQuantity quantity);

/// By how much the mean segment TCD / NCL depends on the ball: the greatest of
/// (max - min) / mean over the three diameters, of all tolerances and directions.
double segment_spread(const EconomyTables& tables);

/// Travel times the interval on a plane, TCD 2 sqrt(2 R h - h^2), in mm^2: an upper bound
/// of the area if no interval exceeds that on a plane. Over the nine cells.
/// \param scallop_per_tolerance h / delta.
ValueRange travel_times_plane_interval(const EconomyTables& tables, Parameter direction,
                                       double scallop_per_tolerance);

/// Whether every row of both tables falls as the ball grows.
bool falls_with_diameter(const EconomyTables& tables);

/// Whether v costs less than u in all nine cells of both tables.
bool v_beats_u(const EconomyTables& tables);

/// Mean of (changed - defaults) / defaults over the nine cells of a table's direction.
double mean_change(const EconomyTables& defaults, const EconomyTables& changed,
                   TableQuantity quantity, Parameter direction);

/// Greatest deviation of a cell of `tables` from that of `reference`, as a share.
double worst_deviation(const EconomyTables& tables, const EconomyTables& reference);

}  // namespace endmill
