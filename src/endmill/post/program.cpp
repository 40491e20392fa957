// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"

namespace endmill {

std::size_t points_within(double memory_gib)
{
    // A growing vector needs the memory of its points three times: once for the old
    // array, and twice for the new array of double size.
    constexpr double bytes_per_point = 3 * sizeof(PathPoint);
    constexpr double most = std::numeric_limits<int>::max();  // point numbers are int
    return static_cast<std::size_t>(
        std::min(std::floor(memory_gib * bytes_per_gib / bytes_per_point), most));
}

void require_sound(const GcodeReadOptions& options)
{
    const auto is_positive = [](double value) {
        return std::isfinite(value) && value > 0;
    };
    require(is_positive(options.arc_tolerance_mm),
            "GcodeReadOptions: need 0 < arc tolerance");
    require(is_positive(options.max_extent_mm),
            "GcodeReadOptions: need 0 < largest extent");
    require(std::isfinite(options.programmed_point_height_mm) &&
                options.programmed_point_height_mm >= 0,
            "GcodeReadOptions: need 0 <= height of the programmed point");
    require(options.most_points <= std::numeric_limits<int>::max(),
            "GcodeReadOptions: need at most 2^31 - 1 points");
}

}  // namespace endmill
