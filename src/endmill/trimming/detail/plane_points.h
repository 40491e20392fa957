// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// The points of all curves of a plane in one row. Segment i joins points i and i + 1.
/// There is no segment from the last point of a curve to the first point of the next.
struct SectionPoints {
    std::span<const SectionPoint> points;  ///< of all curves
    /// for each curve the number behind its last point
    std::span<const std::int32_t> ends;
    double largest_at_most;  ///< upper bound of the size of all coordinates
};

/// Numbers the points of all curves of a plane in one row, and converts these numbers
/// back to the curves' own.
class PlanePoints {
public:
    /// Copies no points if there is a single curve.
    /// \pre the curves outlive this object.
    /// \throws DomainError if a coordinate is not finite.
    /// \throws LimitError if there are 2^31 - 1 points or more.
    explicit PlanePoints(std::span<const SectionCurve> curves);

    // section() refers to the members of this object.
    PlanePoints(const PlanePoints&) = delete;
    PlanePoints& operator=(const PlanePoints&) = delete;

    /// The row of points.
    const SectionPoints& section() const { return section_; }

    /// The segment or vertex `number` of section(), as number of its curve and number in
    /// the curve.
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
