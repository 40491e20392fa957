// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/plane_points.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

// Whether all coordinates are at most `bound` in size; false if one is not a number. The
// loop does not stop early and counts in integers as wide as a coordinate, so that the
// compiler can test several points at a time.
ENDMILL_WIDEST_REGISTERS
bool are_at_most(std::span<const SectionPoint> points, double bound)
{
    std::int64_t larger = 0;
    for (const SectionPoint& point : points) {
        larger |= std::abs(point[0]) <= bound ? 0 : 1;
        larger |= std::abs(point[1]) <= bound ? 0 : 1;
    }
    return larger == 0;
}

// mm. The coordinates of every realistic part are smaller, so that the first test
// decides.
constexpr double usual_size = 1e12;

}  // namespace

PlanePoints::PlanePoints(std::span<const SectionCurve> curves)
    : section_{{}, {}, usual_size}
{
    std::size_t count = 0;
    for (const SectionCurve& curve : curves) {
        if (!are_at_most(curve.points, section_.largest_at_most)) {
            section_.largest_at_most = std::numeric_limits<double>::max();
            require(are_at_most(curve.points, section_.largest_at_most),
                    "trimming: need finite coordinates");
        }
        count += curve.points.size();
        if (count >= std::numeric_limits<std::int32_t>::max())
            throw LimitError{"trimming: more than 2^31 - 2 points in a plane"};
        ends_.push_back(static_cast<std::int32_t>(count));
    }
    if (curves.size() > 1) {
        copied_.reserve(count);
        for (const SectionCurve& curve : curves)
            copied_.insert(copied_.end(), curve.points.begin(), curve.points.end());
    }
    section_.points = curves.size() == 1 ? std::span{curves.front().points}
                                         : std::span<const SectionPoint>{copied_};
    section_.ends = ends_;
}

}  // namespace endmill
