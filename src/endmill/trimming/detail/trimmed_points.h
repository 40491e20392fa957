// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/exact_crossing.h"
#include "endmill/trimming/detail/plane_points.h"

namespace endmill {

/// Makes points of trimmed curves, with their origins, from the numbers of segments and
/// vertices in a plane's row of points.
class TrimmedPoints {
public:
    /// \pre `plane` outlives it.
    explicit TrimmedPoints(const PlanePoints& plane) : plane_{plane} {}

    SectionLine line(std::int32_t segment) const
    {
        return {points()[segment], points()[segment + 1]};
    }

    TrimmedPoint vertex(std::int32_t vertex) const
    {
        const SegmentNumber number = plane_.number(vertex);
        return {points()[vertex], number, number, TrimmedKind::Vertex};
    }

    /// Of two segments with just one point in common.
    TrimmedPoint crossing(std::int32_t p, std::int32_t q) const;

    /// On `segment`, straight above or below `vertex`. \pre s of the vertex is in its range.
    TrimmedPoint link(std::int32_t segment, std::int32_t vertex) const;

private:
    std::span<const SectionPoint> points() const { return plane_.section().points; }

    const PlanePoints& plane_;
};

/// Adds `point` to `curve`. Neighbours that rounding made equal are one: the vertex, if one
/// of them is.
void append(TrimmedCurve& curve, const TrimmedPoint& point);

}  // namespace endmill
