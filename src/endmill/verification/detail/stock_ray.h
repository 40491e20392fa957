// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Returns the material of a block on a ray of the part, before any move.
///
/// If the ray starts inside the block, its thickness is the way along the normal to the
/// block's surface. If it starts outside, material is missing: the thickness is minus the
/// way against the normal, into the part, to the block. If the line misses the block,
/// everything is missing down to the block's floor, or as far as its diagonal is long if
/// that is less.
CutRay ray_in_block(const Block& block, const PartRay& ray);

/// Returns the material of a stock of heights on a ray of the part, such as the stock
/// that an earlier run left.
///
/// Above the part's surface, each height counts for the whole cell, so the thickness is
/// off by as much as the stock changes within a pitch. Below the surface, only what lies
/// above the highest of the cells around is counted as missing, because only that is
/// certain. A gouge on a slope is therefore underestimated; `most_missing` bounds it from
/// above.
CutRay ray_in_stock(const HeightStock& stock, const PartRay& ray);

/// Returns an upper bound in mm of the material that is missing below the part, along the
/// ray's normal, anywhere within `reach` mm of the ray's point; 0 if none is missing.
///
/// The part must be nearly flat within the reach. Between the centres of its cells the
/// surface of the stock is assumed to lie no lower than the lowest centre around, minus a
/// dip: the dip that the second differences of the heights indicate, and at most the dip
/// of a corner whose radius is one pitch. The bound holds for every gouge that is no
/// narrower than a cell. It is 0 where the stock stands higher over the part than a slope
/// changes over the cells around, as an allowance does.
double most_missing(const HeightStock& stock, const PartRay& ray, double reach);

}  // namespace endmill
