// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// The points of all curves of a plane in one row. Segment i joins points i and i + 1;
/// those between two curves are none.
struct SectionPoints {
    std::span<const SectionPoint> points;
    /// Of each curve, the number behind its last point.
    std::span<const std::int32_t> ends;
    double largest_at_most;  ///< bounds the sizes of all coordinates
};

/// The curves of a plane as one row of points, and back to their own numbers.
class PlanePoints {
public:
    /// Copies nothing if there is one curve.
    /// \pre the curves outlive it.
    /// \throws DomainError if a coordinate is not finite; LimitError if there are 2^31 - 1
    ///         points or more.
    explicit PlanePoints(std::span<const SectionCurve> curves);

    PlanePoints(const PlanePoints&) = delete;
    PlanePoints& operator=(const PlanePoints&) = delete;

    const SectionPoints& section() const { return section_; }

    /// The segment or vertex `number` of section() by its curve.
    SegmentNumber number(std::int32_t number) const
    {
        if (ends_.size() == 1)
            return {0, number};
        const auto curve = std::ranges::upper_bound(ends_, number) - ends_.begin();
        return {static_cast<std::int32_t>(curve),
                number - (curve == 0 ? 0 : ends_[curve - 1])};
    }

private:
    std::vector<SectionPoint> copied_;
    std::vector<std::int32_t> ends_;
    SectionPoints section_;
};

}  // namespace endmill
