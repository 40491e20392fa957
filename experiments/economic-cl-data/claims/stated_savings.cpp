// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/claims/stated_savings.h"

#include "endmill/planning/detail/economy_scaling.h"

namespace endmill {

StatedSavings stated_savings(const EconomyTables& tables)
{
    StatedSavings savings{0, 0, 0, 0, falls_with_diameter(tables)};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            savings.points_between_directions +=
                tables.reduction_between_directions(TableQuantity::Ncl, i, j) / 9;
            savings.travel_between_directions +=
                tables.reduction_between_directions(TableQuantity::Tcd, i, j) / 9;
        }
        for (const TableQuantity quantity : table_quantities)
            savings.by_diameter_along_v +=
                tables.reduction_by_diameter(quantity, Parameter::V, i) / 6;
    }
    constexpr int finest = 2;
    for (int j = 0; j < 3; ++j)
        savings.points_at_finest_tolerance +=
            tables.reduction_between_directions(TableQuantity::Ncl, finest, j) / 3;
    return savings;
}

}  // namespace endmill
