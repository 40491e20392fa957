// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "endmill/core/orientation.h"
#include "endmill/trimming/detail/exact_crossing.h"
#include "endmill/trimming/detail/plane_points.h"

namespace endmill {

/// A proper crossing of two segments.
struct EnvelopeCrossing {
    double s;        ///< mm, as z
    double z;        ///< mm
    double error;    ///< bound of the errors of s and of z, mm
    std::int32_t p;  ///< number of one segment
    std::int32_t q;  ///< number of the other
};

/// Factor of an error bound that is compared with a rounded difference. The difference has
/// at least 1 - u of its true size, and a bound that is itself rounded at least 1 - 4u of
/// its own, where u = 2^-53. The factor covers both amply.
inline constexpr double bound_margin = 1.001;

/// Compares segments, vertices and crossings of a plane: above or below, in front or
/// behind. Every answer is exact. Each comparison is first computed in doubles. If the
/// result exceeds its error bound, its sign is certain; otherwise exact_crossing.h
/// decides. The bounds are proved in paper/notes/envelope-filters.md, where u = 2^-53.
class SectionOrder {
public:
    /// \pre the coordinates are finite.
    explicit SectionOrder(const SectionPoints& section);

    /// Whether all coordinates are below 2^250 in size, so that no product of two
    /// lengths overflows.
    bool is_filtered() const { return std::isfinite(slack_); }

    /// s of a vertex in mm
    double s(std::int32_t vertex) const { return points_[vertex][0]; }

    /// The line through the ends of `segment`.
    SectionLine line(std::int32_t segment) const
    {
        return {points_[segment], points_[segment + 1]};
    }

    /// Whether a vertex lies above the line of `segment` (1), on it (0) or below it (-1).
    int side(std::int32_t segment, std::int32_t vertex) const
    {
        const SectionPoint& a = points_[segment];
        const SectionPoint& b = points_[segment + 1];
        const int turn = orientation(a, b, points_[vertex]);
        return a[0] < b[0] ? turn : -turn;
    }

    /// Whether a crossing lies above the line of `segment` (1), on it (0) or below it
    /// (-1).
    int side(std::int32_t segment, const EnvelopeCrossing& crossing) const
    {
        const SectionPoint& a = points_[segment];
        const SectionPoint& b = points_[segment + 1];
        const double ds = b[0] - a[0];
        const double dz = b[1] - a[1];
        const double left = ds * (crossing.z - a[1]);
        const double right = dz * (crossing.s - a[0]);
        const double doubt =
            0x1p-51 * (std::abs(left) + std::abs(right)) + slack_ +
            bound_margin * crossing.error * (std::abs(ds) + std::abs(dz));
        if (std::abs(left - right) > doubt)
            return (left > right) == (ds > 0) ? 1 : -1;
        return exact_side(line(segment), line(crossing.p), line(crossing.q));
    }

    /// Whether p runs above q at s (1), meets q there (0), or runs below q (-1).
    int height_order(std::int32_t p, std::int32_t q, double s) const;

    /// Whether a crossing has a larger s than the given one (1), the same (0) or a
    /// smaller one (-1).
    int order(const EnvelopeCrossing& crossing, double s) const
    {
        const double difference = crossing.s - s;
        if (std::abs(difference) > bound_margin * crossing.error)
            return difference > 0 ? 1 : -1;
        return exact_order(line(crossing.p), line(crossing.q), s);
    }

    /// Whether x has a larger s than y (1), the same (0) or a smaller one (-1).
    int order(const EnvelopeCrossing& x, const EnvelopeCrossing& y) const
    {
        const double difference = x.s - y.s;
        if (std::abs(difference) > bound_margin * (x.error + y.error))
            return difference > 0 ? 1 : -1;
        return exact_order(line(x.p), line(x.q), line(y.p), line(y.q));
    }

    /// The crossing of segments p and q. \pre they have exactly one point in common.
    EnvelopeCrossing crossing(std::int32_t p, std::int32_t q) const;

private:
    std::span<const SectionPoint> points_;
    /// Covers the loss by underflow. It is infinite where coordinates are so large that a
    /// product may overflow, so that the exact functions decide everything.
    double slack_;
};

}  // namespace endmill
