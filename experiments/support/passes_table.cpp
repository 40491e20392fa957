// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/passes_table.h"

#include <cstdint>
#include <variant>

namespace endmill {

NamedCells surface_cells(const OneWayPasses& plan)
{
    constexpr int steps = 1000;
    const SurfaceFacts facts =
        surface_facts(plan.surface, plan.extent, plan.stock_top, steps);
    return {{"least_z_mm", facts.least_z_mm},
            {"greatest_z_mm", facts.greatest_z_mm},
            {"area_mm2", facts.area_mm2},
            {"steepest_deg", facts.steepest_deg},
            {"least_radius_mm", facts.least_radius_mm},
            {"above_stock_percent", 100 * facts.share_above}};
}

NamedCells path_cells(const OneWayPasses& plan)
{
    const MilledPath milled = milled_path(plan);
    return {{"passes", static_cast<std::int64_t>(milled.cuts.back().pass + 1)},
            {"segments", static_cast<std::int64_t>(milled.cuts.size())},
            {"cl_length_mm", length_mm(milled.cuts)}};
}

NamedCells path_cells(const OneWayPasses& plan, double printed_mm)
{
    NamedCells cells = path_cells(plan);
    const double length = std::get<double>(cells.back().second);
    cells.emplace_back("beside_print_percent", 100 * (length / printed_mm - 1));
    return cells;
}

OneWayPasses on_mesh(OneWayPasses plan, int intervals_x, int intervals_y)
{
    plan.surface =
        explicit_surface(gridded(plan.surface, plan.extent, intervals_x, intervals_y));
    return plan;
}

}  // namespace endmill
