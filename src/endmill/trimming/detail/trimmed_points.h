// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/exact_crossing.h"
#include "endmill/trimming/detail/plane_points.h"

namespace endmill {

/// Makes points of trimmed curves, with their origins, from the numbers of segments and
/// vertices in a plane's row of points.
class TrimmedPoints {
public:
    /// \pre `plane` outlives this object.
    explicit TrimmedPoints(const PlanePoints& plane) : plane_{plane} {}

    /// The line through the ends of `segment`.
    SectionLine line(std::int32_t segment) const
    {
        return {points()[segment], points()[segment + 1]};
    }

    /// The vertex itself, with the same bits.
    TrimmedPoint vertex(std::int32_t vertex) const
    {
        const SegmentNumber number = plane_.number(vertex);
        return {points()[vertex], number, number, TrimmedKind::Vertex};
    }

    /// The crossing of segments p and q. \pre they have exactly one point in common.
    TrimmedPoint crossing(std::int32_t p, std::int32_t q) const;

    /// The point of `segment` vertically above or below `vertex`.
    /// \pre s of the vertex lies in the segment's range.
    TrimmedPoint link(std::int32_t segment, std::int32_t vertex) const;

private:
    std::span<const SectionPoint> points() const { return plane_.section().points; }

    const PlanePoints& plane_;
};

/// Appends `point` to `curve`. If rounding made it equal to the last point, only one of
/// the two remains: the vertex, if one of them is a vertex.
inline void append(TrimmedCurve& curve, const TrimmedPoint& point)
{
    auto& points = curve.points;
    if (points.empty() || points.back().at != point.at)
        points.push_back(point);
    else if (points.back().kind != TrimmedKind::Vertex)
        points.back() = point;
}

}  // namespace endmill
