// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/clipped_sections.h"

#include <algorithm>
#include <array>
#include <utility>

namespace endmill {
namespace {

// The segments that a point lies on; for a vertex, the two that meet there.
std::array<SegmentNumber, 2> segments_at(const TrimmedPoint& point)
{
    if (point.kind == TrimmedKind::Vertex)
        return {point.on, SegmentNumber{point.on.curve, point.on.point - 1}};
    return {point.on, point.kind == TrimmedKind::Crossing ? point.across : point.on};
}

// The segment of the section that carries the piece of the result from `a` to `b`.
SegmentNumber segment_between(const TrimmedPoint& a, const TrimmedPoint& b)
{
    const auto candidates = segments_at(b);
    for (const SegmentNumber& segment : segments_at(a))
        if (std::ranges::find(candidates, segment) != candidates.end())
            return segment;
    return a.on;
}

// Clips curves to a range, point by point. A curve is walked from its first to its last
// point; each time it leaves the range, the piece collected so far is finished.
class Clipper {
public:
    explicit Clipper(const Interval& range) : range_{range} {}

    void add(const TrimmedCurve& curve)
    {
        piece_ = {};
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            if (k > 0)
                go(curve.points[k - 1], curve.points[k]);
            if (holds(curve.points[k]))
                piece_.points.push_back(curve.points[k]);
        }
        piece_.is_closed = curve.is_closed && !is_cut_;
        finish();
        is_cut_ = false;
    }

    std::vector<TrimmedCurve> take() { return std::move(pieces_); }

private:
    bool holds(const TrimmedPoint& point) const
    {
        return range_.low <= point.at.x() && point.at.x() <= range_.high;
    }

    // Adds the points at which the segment from `a` to `b` enters and leaves the range.
    void go(const TrimmedPoint& a, const TrimmedPoint& b)
    {
        const bool rises = a.at.x() < b.at.x();
        const double in = rises ? range_.low : range_.high;
        const double out = rises ? range_.high : range_.low;
        const auto passes = [&](double s) {
            return rises ? a.at.x() < s && s < b.at.x() : b.at.x() < s && s < a.at.x();
        };
        if (passes(in)) {
            piece_.points.push_back(end_at(in, a, b));
            is_cut_ = true;
        }
        if (passes(out))
            piece_.points.push_back(end_at(out, a, b));
        if (!holds(b) && !piece_.points.empty()) {
            finish();
            is_cut_ = true;
        }
    }

    static TrimmedPoint end_at(double s, const TrimmedPoint& a, const TrimmedPoint& b)
    {
        const double share = (s - a.at.x()) / (b.at.x() - a.at.x());
        const SegmentNumber on = segment_between(a, b);
        return {{s, a.at.y() + share * (b.at.y() - a.at.y())}, on, on, TrimmedKind::End};
    }

    void finish()
    {
        if (piece_.points.size() > 1)
            pieces_.push_back(std::move(piece_));
        piece_ = {};
    }

    Interval range_;
    TrimmedCurve piece_;
    std::vector<TrimmedCurve> pieces_;
    bool is_cut_ = false;
};

}  // namespace

std::vector<TrimmedCurve> clipped(const std::vector<TrimmedCurve>& curves,
                                  const Interval& range)
{
    Clipper clipper{range};
    for (const TrimmedCurve& curve : curves)
        clipper.add(curve);
    return clipper.take();
}

}  // namespace endmill
