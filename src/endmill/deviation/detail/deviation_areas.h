// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/deviation.h"

namespace endmill {

/// Sums up what the cells of `deviation` have by their areas: the area judged, and mean and
/// 99 % quantile of the rests; 0 without any area.
void add_areas(Deviation& deviation);

}  // namespace endmill
