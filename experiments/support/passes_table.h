// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/process/detail/one_way_passes.h"
#include "support/named_cells.h"

namespace endmill {

/// Measures of the surface of `plan`: least_z_mm, greatest_z_mm, area_mm2, steepest_deg,
/// least_radius_mm, above_stock_percent (of the rectangle).
NamedCells surface_cells(const OneWayPasses& plan);

/// Measures of the path: passes, segments, cl_length_mm.
NamedCells path_cells(const OneWayPasses& plan);

/// The same, and beside_print_percent: the relative difference of the length from
/// `printed_mm`.
NamedCells path_cells(const OneWayPasses& plan, double printed_mm);

/// `plan` with its surface replaced by the spline through a mesh of `intervals_x` by
/// `intervals_y`.
OneWayPasses on_mesh(OneWayPasses plan, int intervals_x, int intervals_y);

}  // namespace endmill
