// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/refined_sections.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace endmill {
namespace {

class Refinement {
public:
    Refinement(const PlacedSection& placed, const DriveFrame& frame,
               const SmoothOffset& offset, const IsAdmissible& is_admissible)
        : section_{placed.section},
          frame_{frame},
          across_{placed.across},
          offset_{offset},
          is_admissible_{is_admissible}
    {
    }

    void add(const TrimmedCurve& curve)
    {
        TrimmedCurve polished = curve;
        for (TrimmedPoint& point : polished.points) {
            const auto place = polished_place(point);
            const double shift = place ? (*place - point.at).norm() : 0;
            if (!place ||
                (is_admissible_ &&
                 !is_admissible_(frame_.point(place->x(), across_, place->y()), shift))) {
                ++result_.unrefined;
                continue;
            }
            ++result_.refined;
            result_.greatest_shift = std::max(result_.greatest_shift, shift);
            point.at = *place;
        }
        leave_out_passed(curve, polished);
        if (polished.is_closed)
            polished.points.back().at = polished.points.front().at;
        result_.curves.push_back(std::move(polished));
    }

    RefinedCurves take() { return std::move(result_); }

private:
    std::optional<SectionPoint> polished_place(const TrimmedPoint& point) const
    {
        if (point.kind == TrimmedKind::Crossing) {
            const auto one = segment_start(point.on, point.at);
            const auto other = segment_start(point.across, point.at);
            return one && other ? crossing_of_sheets(*one, *other, frame_, across_)
                                : std::nullopt;
        }
        const auto start = point.kind == TrimmedKind::Vertex
                               ? vertex_start(point.on)
                               : segment_start(point.on, point.at);
        if (!start)
            return std::nullopt;
        const auto z = height_on_sheet(*start, frame_, point.at.x(), across_);
        return z ? std::optional{SectionPoint{point.at.x(), *z}} : std::nullopt;
    }

    // On a segment, from whichever of its ends is nearer.
    std::optional<SheetStart> segment_start(const SegmentNumber& segment,
                                            const SectionPoint& at) const
    {
        const auto& points = section_.curves[index(segment.curve)].points;
        const std::int32_t next = segment.point + 1;
        const bool is_near_first = (at - points[index(segment.point)]).squaredNorm() <=
                                   (at - points[index(next)]).squaredNorm();
        return edge_start(segment.curve, is_near_first ? segment.point : next,
                          is_near_first ? next : segment.point);
    }

    std::optional<SheetStart> vertex_start(const SegmentNumber& vertex) const
    {
        const auto count =
            static_cast<std::int32_t>(section_.edges[index(vertex.curve)].size());
        const std::int32_t neighbour =
            vertex.point + 1 < count ? vertex.point + 1 : vertex.point - 1;
        return edge_start(vertex.curve, vertex.point, neighbour);
    }

    std::optional<SheetStart> edge_start(std::int32_t curve, std::int32_t point,
                                         std::int32_t neighbour) const
    {
        const auto& edges = section_.edges[index(curve)];
        const CrossedEdge& edge = edges[index(point)];
        const CrossedEdge& next = edges[index(neighbour)];
        const bool shares_below = next.below == edge.below || next.below == edge.above;
        return offset_.start(edge, crossed_at(edge),
                             shares_below ? next.above : next.below);
    }

    // The share of its edge at which the plane crosses it.
    double crossed_at(const CrossedEdge& edge) const
    {
        const auto points = offset_.mesh().points();
        const double below = frame_.across(points[index(edge.below)]);
        const double above = frame_.across(points[index(edge.above)]);
        return (across_ - below) / (above - below);
    }

    // A crossing that moved along s leaves the vertices behind that it went past: they
    // belong to what it cuts off now.
    static void leave_out_passed(const TrimmedCurve& sampled, TrimmedCurve& polished)
    {
        const auto& before = sampled.points;
        auto& points = polished.points;
        std::vector<bool> leaves(points.size(), false);
        const auto is_passed = [&](std::size_t i, std::size_t crossing) {
            const double s = points[i].at.x();
            return (s - before[crossing].at.x()) * (s - points[crossing].at.x()) < 0 ||
                   s == points[crossing].at.x();
        };
        const auto can_leave = [&](std::size_t i, std::size_t crossing) {
            return points[i].kind == TrimmedKind::Vertex && is_passed(i, crossing);
        };
        for (std::size_t k = 0; k < points.size(); ++k) {
            if (points[k].kind != TrimmedKind::Crossing)
                continue;
            for (std::size_t i = k; i-- > 1 && can_leave(i, k);)
                leaves[i] = true;
            for (std::size_t i = k + 1; i + 1 < points.size() && can_leave(i, k); ++i)
                leaves[i] = true;
        }
        std::size_t kept = 0;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (!leaves[k])
                points[kept++] = points[k];
        points.resize(kept);
    }

    static std::size_t index(std::int32_t number)
    {
        return static_cast<std::size_t>(number);
    }

    const PlaneSection& section_;
    const DriveFrame& frame_;
    double across_;
    const SmoothOffset& offset_;
    const IsAdmissible& is_admissible_;
    RefinedCurves result_;
};

}  // namespace

RefinedCurves refined(const std::vector<TrimmedCurve>& curves,
                      const PlacedSection& placed, const DriveFrame& frame,
                      const SmoothOffset& offset, const IsAdmissible& is_admissible)
{
    Refinement refinement{placed, frame, offset, is_admissible};
    for (const TrimmedCurve& curve : curves)
        refinement.add(curve);
    return refinement.take();
}

}  // namespace endmill
