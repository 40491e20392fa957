// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "endmill/core/orientation.h"
#include "endmill/trimming/detail/exact_crossing.h"
#include "endmill/trimming/detail/upper_envelope.h"

namespace endmill {

/// What lies above or before what among segments and their crossings. Every answer is exact;
/// the bounds inside which rounding answers are proved in paper/notes/envelope-filters.md,
/// with u = 2^-53.
class SectionOrder {
public:
    /// \pre the coordinates are finite.
    explicit SectionOrder(const SectionPoints& section);

    double s(std::int32_t vertex) const { return points_[vertex][0]; }  ///< mm

    SectionLine line(std::int32_t segment) const
    {
        return {points_[segment], points_[segment + 1]};
    }

    /// Whether a vertex lies above the line of `segment` (1), on it (0) or below (-1).
    int side(std::int32_t segment, std::int32_t vertex) const
    {
        const SectionPoint& a = points_[segment];
        const SectionPoint& b = points_[segment + 1];
        const int turn = orientation(a, b, points_[vertex]);
        return a[0] < b[0] ? turn : -turn;
    }

    /// Whether a crossing lies above the line of `segment` (1), on it (0) or below (-1).
    int side(std::int32_t segment, const EnvelopeCrossing& crossing) const
    {
        const SectionPoint& a = points_[segment];
        const SectionPoint& b = points_[segment + 1];
        const double ds = b[0] - a[0];
        const double dz = b[1] - a[1];
        const double left = ds * (crossing.z - a[1]);
        const double right = dz * (crossing.s - a[0]);
        const double doubt = 0x1p-51 * (std::abs(left) + std::abs(right)) + slack_ +
                             1.001 * crossing.error * (std::abs(ds) + std::abs(dz));
        if (std::abs(left - right) > doubt)
            return (left > right) == (ds > 0) ? 1 : -1;
        return exact_side(line(segment), line(crossing.p), line(crossing.q));
    }

    /// Whether p runs above q at s (1), meets it there (0), or runs below (-1).
    int height_order(std::int32_t p, std::int32_t q, double s) const;

    /// Whether a crossing has a larger s (1), this one (0) or a smaller one (-1).
    int order(const EnvelopeCrossing& crossing, double s) const
    {
        const double difference = crossing.s - s;
        if (std::abs(difference) > 1.001 * crossing.error)
            return difference > 0 ? 1 : -1;
        return exact_order(line(crossing.p), line(crossing.q), s);
    }

    /// Whether x has a larger s than y (1), the same (0) or a smaller one (-1).
    int order(const EnvelopeCrossing& x, const EnvelopeCrossing& y) const
    {
        const double difference = x.s - y.s;
        if (std::abs(difference) > 1.001 * (x.error + y.error))
            return difference > 0 ? 1 : -1;
        return exact_order(line(x.p), line(x.q), line(y.p), line(y.q));
    }

    /// The crossing of p and q. \pre they have just one point in common.
    EnvelopeCrossing crossing(std::int32_t p, std::int32_t q) const;

private:
    std::span<const SectionPoint> points_;
    /// Covers what underflow takes; infinite, so that nothing passes the bounds, where the
    /// coordinates are so large that a product might overflow.
    double slack_;
};

}  // namespace endmill
