// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/acceptance/acceptance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/planning/detail/scallop_between.h"
#include "endmill/surface/tool_side.h"
#include "support/median.h"

namespace endmill {
namespace {

bool lies_in(const ValueRange& outer, double value)
{
    return outer.least <= value && value <= outer.greatest;
}

bool lies_in(const ValueRange& outer, const ValueRange& inner)
{
    return lies_in(outer, inner.least) && lies_in(outer, inner.greatest);
}

// Whether an exponent lies in `range` for both directions.
bool exponents_lie_in(const ValueRange& range, const EconomyTables& tables,
                      TableQuantity quantity, double ScalingLaw::*exponent)
{
    return std::ranges::all_of(table_directions, [&](Parameter direction) {
        return lies_in(range, scaling_law(tables, quantity, direction).*exponent);
    });
}

}  // namespace

CuspCheck check_cusps(const Surface& surface)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CuspCheck check{{infinity, -infinity}, 0};
    for (const Parameter direction : table_directions)
        for (const double tolerance : table_tolerances_mm)
            for (const double diameter : table_diameters_mm) {
                const IsoParametricPlan plan =
                    table_plan(surface, {}, direction, tolerance, diameter);
                std::vector<double> cusps = governing_scallops(
                    surface, BallCutter{diameter / 2}, plan, direction);
                require(!cusps.empty(), "check_cusps: a run has a single pass");
                for (double& cusp : cusps)
                    cusp /= tolerance;  // table_plan uses it as scallop height
                const auto [least, greatest] = std::ranges::minmax(cusps);
                check.pairs.least = std::min(check.pairs.least, least);
                check.pairs.greatest = std::max(check.pairs.greatest, greatest);
                check.worst_median =
                    std::max(check.worst_median, std::abs(median(cusps) - 1));
            }
    return check;
}

bool Acceptance::travel_falls_with_root_of_tolerance() const
{
    return exponents_lie_in({-0.53, -0.46}, tables, TableQuantity::Tcd,
                            &ScalingLaw::tolerance_exponent);
}

bool Acceptance::points_fall_with_tolerance() const
{
    return exponents_lie_in({-1.06, -0.94}, tables, TableQuantity::Ncl,
                            &ScalingLaw::tolerance_exponent);
}

bool Acceptance::both_fall_with_root_of_radius() const
{
    return std::ranges::all_of(table_quantities, [&](TableQuantity quantity) {
        return exponents_lie_in({-0.54, -0.46}, tables, quantity,
                                &ScalingLaw::diameter_exponent);
    });
}

bool Acceptance::doubling_the_ball_saves() const
{
    return lies_in({0.27, 0.31}, reductions_by_diameter(tables));
}

bool Acceptance::segments_depend_on_tolerance_only() const
{
    return segment_spread(tables) <= 0.025;
}

bool Acceptance::cells_are_near(const EconomyTables& printed) const
{
    return worst_deviation(tables, printed) <= 0.04 && v_beats_u(tables) &&
           lies_in({0.20, 0.31},
                   reductions_between_directions(tables, TableQuantity::Ncl)) &&
           lies_in({0.03, 0.13},
                   reductions_between_directions(tables, TableQuantity::Tcd));
}

bool Acceptance::cusps_are_as_asked() const
{
    return cusps.worst_median <= 0.01;
}

Acceptance acceptance_of(const Surface& surface)
{
    const auto limit = largest_cutter(surface, tool_side_sign(surface, Vec3::UnitZ()));
    require(limit.has_value(), "acceptance_of: the surface has no largest cutter");
    return {*limit, planned_tables(surface), check_cusps(surface)};
}

}  // namespace endmill
