// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"

namespace endmill {

/// Chord tolerances of [KimChoi, tables 1 and 2] in mm. Each tolerance is combined with
/// each diameter and each direction: 18 runs.
inline constexpr std::array<double, 3> table_tolerances_mm{1, 0.5, 0.2};
inline constexpr std::array<double, 3> table_diameters_mm{10, 15,
                                                          20};  ///< of the ball, mm
inline constexpr std::array<Parameter, 2> table_directions{
    Parameter::U, Parameter::V};  ///< directions of the passes

/// The quantity that a table lists.
enum class TableQuantity {
    Ncl,  ///< table 1: number of CL points
    Tcd,  ///< table 2: total cutter travel, mm
};
inline constexpr std::array<TableQuantity, 2> table_quantities{
    TableQuantity::Ncl, TableQuantity::Tcd};  ///< both tables

/// The cells of both tables: points and travel of the 18 runs.
struct EconomyTables {
    /// Indices: direction (u, v), tolerance, diameter.
    std::array<std::array<std::array<DirectionCost, 3>, 3>, 2> runs{};

    /// One cell. \pre `tolerance` and `diameter` are indices, 0 to 2.
    double cell(TableQuantity quantity, Parameter direction, int tolerance,
                int diameter) const;

    /// (max - min) / max of the cells of the two directions.
    /// Source: [KimChoi, heads of tables 1 and 2].
    double reduction_between_directions(TableQuantity quantity, int tolerance,
                                        int diameter) const;

    /// (small - large) / small of the cells of the smallest and the largest ball.
    double reduction_by_diameter(TableQuantity quantity, Parameter direction,
                                 int tolerance) const;
};

/// The choices that the paper leaves open, the same for all 18 runs.
struct TablePolicies {
    IsoParametricOptions plan;  ///< each run sets direction, tolerance and scallop itself
    double scallop_per_tolerance = 1;  ///< scallop height / chord tolerance
    CountedMoves counted = CountedMoves::CutsAndLinks;  ///< moves in the travel
    TravelKind distance = TravelKind::Contact;          ///< points that travel
};

/// Plans one of the 18 runs on `surface`.
/// \throws as `plan_iso_parametric`.
IsoParametricPlan table_plan(const Surface& surface, const TablePolicies& policies,
                             Parameter direction, double tolerance_mm,
                             double diameter_mm);

/// Points and travel of `path`, counted by `policies`.
DirectionCost path_cost(const ToolPath& path, const TablePolicies& policies);

/// Plans all 18 runs on `surface`. \throws as `plan_iso_parametric`.
EconomyTables planned_tables(const Surface& surface, const TablePolicies& policies = {});

}  // namespace endmill
