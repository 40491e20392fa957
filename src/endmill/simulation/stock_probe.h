// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Internal to simulation: a stock looked into, and cut, a move at a time.

#include <optional>

#include "endmill/cutter/cutter.h"
#include "endmill/simulation/height_stock.h"
#include "endmill/simulation/swept_move.h"

namespace endmill {

/// Height in mm at a place, linear between the centres of the cells; nothing beside the grid.
std::optional<double> height_under(const HeightStock& stock, double x, double y);

/// Takes from `stock` what `cutter` sweeps on `move`.
void take_swept(HeightStock& stock, const Cutter& cutter, const SweptMove& move);

}  // namespace endmill
