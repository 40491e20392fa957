// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/simulation/height_stock.h"
#include "endmill/simulation/mown_ray.h"

namespace endmill {

/// What of a ray of the part lies in a block, before any move: up to where it leaves the
/// block's box. Nothing if it begins outside.
MownRay ray_in_block(const Block& block, const PartRay& ray);

/// The same in a stock of heights, each of which counts for the whole of its cell: off by
/// what the stock changes within a pitch. What an earlier run took from the part itself is
/// not told: a ray that begins above the stock has nothing left.
MownRay ray_in_stock(const HeightStock& stock, const PartRay& ray);

}  // namespace endmill
