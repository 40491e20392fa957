// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/stock/height_stock.h"
#include "endmill/surface/part.h"

namespace endmill {

/// Returns the box of a part along the coordinate axes, mm. Points of a mesh that no
/// triangle uses do not count. The box of an empty part has infinite corners.
Block bounding_box(const Part& part);

}  // namespace endmill
