// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/stock/height_stock.h"

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
/// tell for certain. So a gouge shows less deep on a slope: `most_missing` bounds it.
MownRay ray_in_stock(const HeightStock& stock, const PartRay& ray);

/// How much of a stock of heights may be missing below the part, in mm along the ray's
/// normal, anywhere within `reach` mm of the ray's point on a part that is about flat
/// there: 0 or more. Between the centres of its cells the surface is taken to be nowhere
/// lower than at the lowest of the centres around, less what it dips between them if it
/// bends as they do and as a corner at least a pitch wide: that holds but for what is
/// narrower than a cell. What stands higher than the part by more than a slope changes over the
/// cells around, such as an allowance, is known so to be there.
double most_missing(const HeightStock& stock, const PartRay& ray, double reach);

}  // namespace endmill
