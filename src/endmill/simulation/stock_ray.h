// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/simulation/height_stock.h"
#include "endmill/simulation/mown_ray.h"

namespace endmill {

/// What of a ray of the part lies in a block, before any move: up to where it leaves the
/// block's box. If it begins outside, material is missing below its point: up to where the
/// ray, drawn on into the part, meets the box, which counts as below 0. Where it never does,
/// all is missing as far as the box reaches: down to its floor, or its diagonal if that is
/// less.
MownRay ray_in_block(const Block& block, const PartRay& ray);

/// The same in a stock of heights, such as an earlier run leaves. Over its point each height
/// counts for the whole of its cell: off by what the stock changes within a pitch. Below it
/// only that is missing which lies above the highest cell around: what the heights of cells
/// tell for certain. So a gouge shows less deep, by up to `shallower_by`.
MownRay ray_in_stock(const HeightStock& stock, const PartRay& ray);

/// By how much less deep, in mm, a gouge in a stock of this pitch may show whose floor is even
/// over the cells around: on no slope by nothing, on any slope by no more than this. The
/// highest cell around ends 1.5 pitches away along x and y, so that it is higher by 1.5
/// pitches times the slopes along both, and nearer along the normal by its cosine less.
double shallower_by(double pitch);

}  // namespace endmill
