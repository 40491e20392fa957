// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/deviation/detail/ray_rows.h"

namespace endmill {

/// Shortens rays by the volume that a ball sweeps on a move. The result is that of
/// `cut_ray` for each ray, within rounding, but several rays are processed at once.
/// \param number of the sweep.
/// \param short_by below 0 for the rays that the move may shorten.
void shorten_by_ball(RayRows& rows, const StraightSweep& sweep, std::int32_t number,
                     const RayRows::Row& short_by);

}  // namespace endmill
