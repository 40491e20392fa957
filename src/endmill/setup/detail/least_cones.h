// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/setup/detail/distinct_cones.h"

namespace endmill {

/// The cones that hold no other one, by their sizes and then their numbers: what meets these
/// meets all.
///
/// A cone holds another if that has no cell outside. Of all cones kept so far those with a cell
/// among some of the cells outside are struck out, 512 at a time, which leaves few to be
/// compared; so that the work, quadratic in cones, costs less than a nanosecond a pair. Cones of one
/// size do not hold each other and are dealt with on all threads; the answer does not depend on
/// their number.
std::vector<std::size_t> least_cones(const DistinctCones& cones);

}  // namespace endmill
