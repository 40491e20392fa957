// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/stock/height_stock.h"

namespace endmill {

/// Memory in bytes that the stock over `box` takes at most, the work of `remove_along`
/// included but not its result, which grows with the path.
/// \param extra bytes a cell for what else is made of the stock.
/// \pre the box is finite and not turned over, 0 < pitch.
double required_bytes(const Block& box, double pitch, double extra = 0);

/// The finest pitch of two digits, in mm, at which the stock over `box` fits `bytes`.
/// \param extra as `required_bytes`.
/// \return nothing if not even a single tile fits.
std::optional<double> fitting_pitch(const Block& box, double bytes, double extra = 0);

/// Refuses, before any memory is taken, a stock that would not fit `memory_gib`.
/// \param extra as `required_bytes`.
/// \throws DomainError as `grid_over`.
/// \throws LimitError that names need and limit, and a pitch that fits.
void require_stock_memory(const Block& box, double pitch, double memory_gib,
                          double extra = 0);

}  // namespace endmill
