// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "endmill/planning/detail/composite_curve.h"
#include "endmill/planning/detail/economy_tables.h"

/// \file
/// The 18 runs of the paper's tables on a translational surface, two to three times faster
/// than by the planner.

namespace endmill {

/// The translational surface r(u, v) = A(u) + B(v).
struct TranslationalSurface {
    CompositeCurve along_u;  ///< A
    CompositeCurve along_v;  ///< B
};

/// The surface as a composite Bezier net with the control points a_i + b_j.
Surface as_surface(const TranslationalSurface& surface);

/// The form of the path interval.
enum class IntervalArithmetic {
    Exact,          ///< the library's path_interval
    PrintedSingle,  ///< eq. (4) and (5) as printed, in 24 bits
};

/// The choices of a run. `table.plan` holds the choices of the planner, of which `link`,
/// `progress` and `most_points` are not used.
struct RunPolicies {
    TablePolicies table;  ///< see there
    IntervalArithmetic interval = IntervalArithmetic::Exact;
    double radius_per_diameter = 0.5;  ///< 1 if the tables' D were the radius R
    /// Whether all passes have the parameters of the points of the first pass. It differs
    /// from March::Forward only for StepCurvature::Normal.
    bool points_of_first_pass = false;
};

/// The marched points of one pass.
struct MarchedCurve {
    std::vector<double> parameters;  ///< in the order of the march
    double steps;                    ///< number of steps; the last one counts as a share
};

/// The points of one pass by the curvature of the curve itself, as [KimChoi, eq. (1) to (3)].
/// \param curve the pass; its second and later derivatives may jump at joints.
/// \param chord_tolerance delta in mm.
/// \param end_point what ends the pass.
/// \param borders   whether joints are points.
/// \return nothing if a step makes no progress.
std::optional<MarchedCurve> march_curve(const CompositeCurve& curve,
                                        double chord_tolerance,
                                        EndPoint end_point = EndPoint::Force,
                                        PatchBorders borders = PatchBorders::Cross);

/// One of the 18 runs.
struct TableRun {
    DirectionCost cost;  ///< NCL and TCD
    int passes;          ///< N
    double
        passes_real;  ///< N with a fractional last interval; N is the next whole number
};

/// Which of the 18 runs: indices of direction (u, v), tolerance and diameter.
struct RunPlace {
    int direction;
    int tolerance;
    int diameter;
};

/// All runs. Indices: direction (u, v), tolerance, diameter.
using TableRuns = std::array<std::array<std::array<TableRun, 3>, 3>, 2>;

/// Computes the 18 runs on `surface`, those with few points first, until `visit` returns false.
/// The results are those of `table_plan`: NCL equal, TCD to a relative 1e-9.
/// \return false if a run does not exist: the ball does not fit, the normal of a contact is
///         not above the xy plane, a pass makes no progress, or there are more than 400
///         passes. No further run is then computed.
bool visit_runs(const TranslationalSurface& surface, const RunPolicies& policies,
                const std::function<bool(const RunPlace&, const TableRun&)>& visit);

/// All runs on `surface`. \return nothing if one does not exist, see visit_runs.
std::optional<TableRuns> table_runs(const TranslationalSurface& surface,
                                    const RunPolicies& policies);

/// The cells of the runs.
EconomyTables tables_of(const TableRuns& runs);

}  // namespace endmill
