// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/setup/detail/distinct_cones.h"

namespace endmill {

/// Selects the minimal cones: those that contain no other cone. A set of directions that
/// meets all minimal cones meets all cones. The result is sorted by size, then by number,
/// and does not depend on the number of threads.
///
/// The work is quadratic in the number of cones, at less than a nanosecond for each pair.
std::vector<std::size_t> least_cones(const DistinctCones& cones);

}  // namespace endmill
