// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/envelope_trimming.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "endmill/trimming/detail/section_order.h"
#include "endmill/trimming/detail/trimmed_points.h"
#include "endmill/trimming/detail/upper_envelope.h"

namespace endmill {
namespace {

// The vertical segment with the highest top among those at one s; among equal ones the
// first.
struct Vertical {
    std::int32_t segment;
    std::int32_t top;  // vertices
    std::int32_t bottom;
};

// The highest vertical segment of each s that has one, ordered by s.
std::vector<Vertical> highest_verticals(std::span<const SectionPoint> points,
                                        std::span<const std::int32_t> segments)
{
    std::vector<Vertical> verticals;
    for (const std::int32_t k : segments) {
        if (points[k][1] != points[k + 1][1]) {
            const bool is_upwards = points[k][1] < points[k + 1][1];
            verticals.push_back({k, is_upwards ? k + 1 : k, is_upwards ? k : k + 1});
        }
    }
    std::ranges::sort(verticals, [&](const Vertical& a, const Vertical& b) {
        const SectionPoint& p = points[a.top];
        const SectionPoint& q = points[b.top];
        if (p[0] != q[0])
            return p[0] < q[0];
        return p[1] != q[1] ? p[1] > q[1] : a.segment < b.segment;
    });
    const auto has_same_s = [&](const Vertical& a, const Vertical& b) {
        return points[a.top][0] == points[b.top][0];
    };
    verticals.erase(std::unique(verticals.begin(), verticals.end(), has_same_s),
                    verticals.end());
    return verticals;
}

// Writes the result as curves. upper_envelope returns the pieces of the envelope of all
// segments that are not vertical. The writer merges two lists that are ordered by s:
// 1. The places at which the carrier of the envelope changes: vertices and crossings.
//    Each becomes a crossing, a vertex, or a vertical link between two limits of the
//    envelope.
// 2. The vertical segments. One that rises above the envelope becomes a spike: up to its
//    top and back. One over which no other segment lies becomes a curve of its own. A
//    curve ends where no segment carries the envelope. All comparisons are exact
//    (SectionOrder).
class Writer {
public:
    explicit Writer(const PlanePoints& plane)
        : plane_{plane},
          points_{plane.section().points},
          made_{plane},
          order_{plane.section()},
          envelope_{upper_envelope(plane.section())},
          verticals_{highest_verticals(points_, envelope_.verticals)}
    {
    }

    Trimmed write()
    {
        const auto& pieces = envelope_.pieces;
        std::int32_t left = no_segment;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            if (!is_left_of_all(pieces[k].from))
                write_place({left, pieces[k].segment}, pieces[k].from,
                            left == no_segment ? places_of_curve(k) : 0);
            left = pieces[k].segment;
        }
        if (!pieces.empty())
            write_place({left, no_segment}, envelope_.end, 0);
        while (next_vertical_ < verticals_.size())
            write_lone(take_vertical());
        return std::move(trimmed_);
    }

private:
    // The segments that carry the envelope left and right of a place.
    struct Sides {
        std::int32_t left;
        std::int32_t right;
    };

    bool is_left_of_all(std::int32_t place) const
    {
        return place < 0 && envelope_.crossings[~place].p == no_segment;
    }

    // The number of places on the curve that begins with piece k. Curves do not share room:
    // a plane may have millions of them.
    std::size_t places_of_curve(std::size_t k) const
    {
        const auto begin = envelope_.pieces.begin() + static_cast<std::ptrdiff_t>(k);
        const auto end = std::ranges::find(begin, envelope_.pieces.end(), no_segment,
                                           &EnvelopePiece::segment);
        return static_cast<std::size_t>(end - begin) + 1;
    }

    // Writes the vertical segments in front of `place`, then the place itself. A curve that
    // begins there has `most_places`, as far as it is known.
    void write_place(const Sides& sides, std::int32_t place, std::size_t most_places)
    {
        if (is_common_vertex(sides, place) && order_.s(place) < next_vertical_s_) {
            write(made_.vertex(place));
            return;
        }
        while (next_vertical_ < verticals_.size() && compare_next_vertical(place) < 0) {
            const Vertical& vertical = take_vertical();
            if (sides.left == no_segment)
                write_lone(vertical);
            else if (order_.side(sides.left, vertical.top) > 0)
                write_spike(sides.left, vertical);
        }
        if (sides.left == no_segment) {
            trimmed_.curves.emplace_back();
            // Most places become one point, and steps two or three. Room that is too
            // small by one point would be copied and doubled.
            trimmed_.curves.back().points.reserve(most_places + most_places / 8 + 2);
        }
        const Vertical* vertical = nullptr;
        if (next_vertical_ < verticals_.size() && compare_next_vertical(place) == 0)
            vertical = &take_vertical();
        if (place < 0)
            write_crossing(sides, vertical);
        else
            write_vertex(sides, place, vertical);
    }

    // Moves on behind the next vertical segment, and returns it.
    const Vertical& take_vertical()
    {
        const Vertical& vertical = verticals_[next_vertical_++];
        next_vertical_s_ = next_vertical_s();
        return vertical;
    }

    double next_vertical_s() const
    {
        return next_vertical_ < verticals_.size()
                   ? order_.s(verticals_[next_vertical_].top)
                   : std::numeric_limits<double>::infinity();
    }

    // Whether `place` is the vertex between two consecutive segments of a curve.
    static bool is_common_vertex(const Sides& sides, std::int32_t place)
    {
        return (sides.right == place && sides.left == place - 1) ||
               (sides.left == place && sides.right == place - 1);
    }

    // Whether the next vertical segment lies in front of `place` (-1), at its s (0) or
    // behind it (1).
    int compare_next_vertical(std::int32_t place) const
    {
        if (place < 0)
            return -order_.order(envelope_.crossings[~place], next_vertical_s_);
        const double s = order_.s(place);
        return (next_vertical_s_ > s) - (next_vertical_s_ < s);
    }

    void write_crossing(const Sides& sides, const Vertical* vertical)
    {
        const TrimmedPoint point = made_.crossing(sides.left, sides.right);
        write(point);
        // The comparison uses the exact crossing; the rounded one may lie above the
        // vertical's top.
        if (vertical && order_.side(sides.left, vertical->top) > 0) {
            write(made_.vertex(vertical->top));
            write(point);
        }
    }

    void write_vertex(const Sides& sides, std::int32_t place, const Vertical* vertical)
    {
        const Limit left = limit_at(sides.left, place);
        const Limit right = limit_at(sides.right, place);
        if (vertical && is_above(vertical->top, left) && is_above(vertical->top, right)) {
            write_limit(left, {vertical->top, vertical});
            write(made_.vertex(vertical->top));
            write_limit(right, {vertical->top, vertical});
            return;
        }
        if (left.is_vertex() && right.is_vertex() &&
            points_[left.vertex] == points_[right.vertex]) {
            write(made_.vertex(std::min(left.vertex, right.vertex)));
            return;
        }
        // the place is a vertex of a segment that does not carry the envelope
        if (left.is_link() && right.is_link()) {
            write(made_.crossing(sides.left, sides.right));
            return;
        }
        const Jump jump{left.is_vertex() ? left.vertex : right.vertex, vertical};
        if (!left.is_link() || is_above(jump.upper, left))
            write_limit(left, jump);
        if (!right.is_link() || is_above(jump.upper, right))
            write_limit(right, jump);
    }

    // The limit of the envelope at the s of a vertex, from one side.
    struct Limit {
        std::int32_t segment;  // or no_segment
        std::int32_t vertex;   // the segment's vertex at that s, or negative
        bool is_vertex() const { return vertex >= 0; }
        bool is_link() const { return segment != no_segment && vertex < 0; }
    };

    // A vertical step of the envelope: its upper end, and the vertical segment at that s,
    // if any.
    struct Jump {
        std::int32_t upper;
        const Vertical* vertical;
    };

    Limit limit_at(std::int32_t segment, std::int32_t place) const
    {
        if (segment == no_segment)
            return {no_segment, -1};
        for (const std::int32_t vertex : {segment, segment + 1})
            if (order_.s(vertex) == order_.s(place))
                return {segment, vertex};
        return {segment, -1};
    }

    bool is_above(std::int32_t vertex, const Limit& limit) const
    {
        if (limit.segment == no_segment)
            return true;
        if (limit.is_vertex())
            return points_[vertex][1] > points_[limit.vertex][1];
        return order_.side(limit.segment, vertex) > 0;
    }

    void write_limit(const Limit& limit, const Jump& jump)
    {
        if (limit.is_vertex())
            write(made_.vertex(limit.vertex));
        else if (limit.segment != no_segment)
            write(link_point(limit.segment, jump));
    }

    void write_spike(std::int32_t segment, const Vertical& vertical)
    {
        const TrimmedPoint foot = link_point(segment, {vertical.top, &vertical});
        write(foot);
        write(made_.vertex(vertical.top));
        write(foot);
    }

    void write_lone(const Vertical& vertical)
    {
        trimmed_.curves.emplace_back();
        write(made_.vertex(vertical.bottom));
        write(made_.vertex(vertical.top));
    }

    // The lower end of a step. It is a crossing if a vertical segment spans the whole
    // step, otherwise a link.
    TrimmedPoint link_point(std::int32_t segment, const Jump& jump) const
    {
        TrimmedPoint point = made_.link(segment, jump.upper);
        const Vertical* vertical = jump.vertical;
        if (vertical && points_[jump.upper][1] <= points_[vertical->top][1] &&
            order_.side(segment, vertical->bottom) <= 0) {
            point.across = plane_.number(vertical->segment);
            point.kind = TrimmedKind::Crossing;
        }
        return point;
    }

    void write(const TrimmedPoint& point) { append(trimmed_.curves.back(), point); }

    const PlanePoints& plane_;
    std::span<const SectionPoint> points_;
    TrimmedPoints made_;
    SectionOrder order_;
    UpperEnvelope envelope_;
    std::vector<Vertical> verticals_;
    std::size_t next_vertical_ = 0;
    double next_vertical_s_ = next_vertical_s();  // infinite if none is left
    Trimmed trimmed_;
};

}  // namespace

Trimmed envelope_trimming(std::span<const SectionCurve> curves,
                          const TrimmingOptions& /*options*/)
{
    Trimmed trimmed = Writer{PlanePoints{curves}}.write();
    trimmed.rule = "below the envelope";
    return trimmed;
}

EnvelopeHeight::EnvelopeHeight(std::span<const SectionCurve> curves)
{
    for (const TrimmedCurve& curve : envelope_trimming(curves).curves)
        for (std::size_t k = 0; k < curve.points.size(); ++k)
            points_.push_back({curve.points[k].at, k > 0});
}

std::optional<double> EnvelopeHeight::at(double s) const
{
    const auto is_before = [](const Point& point, double at) {
        return point.at.x() < at;
    };
    auto next = std::lower_bound(points_.begin(), points_.end(), s, is_before);
    std::optional<double> height;
    if (next != points_.begin() && next != points_.end() && next->is_joined) {
        const SectionPoint& before = (next - 1)->at;
        const double share = (s - before.x()) / (next->at.x() - before.x());
        height = std::lerp(before.y(), next->at.y(), share);
    }
    for (; next != points_.end() && next->at.x() == s; ++next)
        height = std::max(height.value_or(next->at.y()), next->at.y());
    return height;
}

}  // namespace endmill
