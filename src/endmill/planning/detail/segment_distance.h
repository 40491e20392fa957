// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "endmill/core/vec.h"

/// \file
/// Distance of a point from a straight move.

namespace endmill {

/// The point of the segment from `start` to `end` that is nearest to `point`. It is
/// `start` if the segment has no length.
inline Vec3 nearest_on_segment(const Vec3& point, const Vec3& start, const Vec3& end)
{
    const Vec3 chord = end - start;
    const double square = chord.squaredNorm();
    const double share =
        square > 0 ? std::clamp((point - start).dot(chord) / square, 0.0, 1.0) : 0;
    return start + share * chord;
}

/// Distance in mm between `point` and the segment from `start` to `end`.
inline double segment_distance(const Vec3& point, const Vec3& start, const Vec3& end)
{
    return (point - nearest_on_segment(point, start, end)).norm();
}

}  // namespace endmill
