// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/claims/stated_savings.h"

#include <cmath>

#include "endmill/core/text.h"
#include "endmill/planning/detail/economy_scaling.h"
#include "support/experiment.h"

namespace endmill {
namespace {

// Whether the reductions along v from the ball `small` to the ball `large` round to the printed ones.
bool gives_last_column(const EconomyTables& printed, int small, int large)
{
    for (const TableQuantity quantity : table_quantities)
        for (int i = 0; i < 3; ++i) {
            const std::string table = quantity == TableQuantity::Ncl
                                          ? "economic-cl-data/table-1"
                                          : "economic-cl-data/table-2";
            const double stated = published_number(
                table, "print d=" + to_text(table_tolerances_mm[i]) + " v",
                "reduction_d10_d20_percent");
            const double first = printed.cell(quantity, Parameter::V, i, small);
            const double last = printed.cell(quantity, Parameter::V, i, large);
            if (std::round(100 * (first - last) / first) != stated)
                return false;
        }
    return true;
}

}  // namespace

StatedSavings stated_savings(const EconomyTables& tables)
{
    StatedSavings savings{
        .points_between_directions = 0,
        .travel_between_directions = 0,
        .points_at_finest_tolerance = 0,
        .by_diameter_along_v = 0,
        .by_diameter = 0,
        .least_points_between_directions =
            reductions_between_directions(tables, TableQuantity::Ncl).least,
        .least_travel_between_directions =
            reductions_between_directions(tables, TableQuantity::Tcd).least,
        .larger_is_better = falls_with_diameter(tables),
        .v_beats_u = v_beats_u(tables),
    };
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            savings.points_between_directions +=
                tables.reduction_between_directions(TableQuantity::Ncl, i, j) / 9;
            savings.travel_between_directions +=
                tables.reduction_between_directions(TableQuantity::Tcd, i, j) / 9;
        }
        for (const TableQuantity quantity : table_quantities) {
            savings.by_diameter_along_v +=
                tables.reduction_by_diameter(quantity, Parameter::V, i) / 6;
            for (const Parameter direction : table_directions)
                savings.by_diameter +=
                    tables.reduction_by_diameter(quantity, direction, i) / 12;
        }
    }
    constexpr int finest = 2;
    for (int j = 0; j < 3; ++j)
        savings.points_at_finest_tolerance +=
            tables.reduction_between_directions(TableQuantity::Ncl, finest, j) / 3;
    return savings;
}

std::string columns_of_last_column(const EconomyTables& printed)
{
    std::string found = "none";
    for (int small = 0; small < 3; ++small)
        for (int large = small + 1; large < 3; ++large) {
            if (!gives_last_column(printed, small, large))
                continue;
            found = found == "none" ? "diameter " + to_text(table_diameters_mm[small]) +
                                          ", " + to_text(table_diameters_mm[large])
                                    : "several";
        }
    return found;
}

}  // namespace endmill
