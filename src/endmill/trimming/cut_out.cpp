// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/cut_out.h"

#include <algorithm>
#include <cstdlib>

#include "endmill/core/orientation.h"

namespace endmill {
namespace {

constexpr std::int32_t cut = -1;

// Consecutive segments of a curve.
struct Segments {
    std::int32_t first;
    std::int32_t last;
};

// The position of every section point in the result. The points of the result are stored
// in one row, with an empty entry between curves, so that neighbours in a curve are
// neighbours in the row.
class KeptPoints {
public:
    KeptPoints(std::span<const SectionCurve> curves, const Trimmed& trimmed)
        : places_(curves.size()),
          crossings_(curves.size(), nullptr),
          ends_(curves.size(), nullptr)
    {
        for (std::size_t c = 0; c < curves.size(); ++c)
            places_[c].resize(curves[c].points.size(), cut);
        row_.push_back(nullptr);
        for (const TrimmedCurve& curve : trimmed.curves) {
            for (const TrimmedPoint& point : curve.points)
                add(point);
            row_.push_back(nullptr);
        }
        for (std::size_t c = 0; c < curves.size(); ++c) {
            if (curves[c].is_closed)
                places_[c].front() = places_[c].back() =
                    std::max(places_[c].front(), places_[c].back());
        }
    }

    bool has(std::int32_t curve, std::int32_t point) const
    {
        return places_[curve][point] != cut;
    }

    // The coordinates of a kept vertex in the result; a refined result may have moved it.
    const SectionPoint& at(SegmentNumber vertex) const
    {
        return row_[places_[vertex.curve][vertex.point]]->at;
    }

    // The point of `kind` that follows or precedes the kept `vertex` in the result and
    // lies on one of `segments` of the same curve; null if there is none. As a rule it
    // lies on the first or on the last of them. Other segments occur because refinement
    // moves crossings past vertices.
    const TrimmedPoint* beside(SegmentNumber vertex, const Segments& segments,
                               TrimmedKind kind) const
    {
        const auto holds = [&](SegmentNumber segment) {
            return segment.curve == vertex.curve && segments.first <= segment.point &&
                   segment.point <= segments.last;
        };
        const std::int32_t place = places_[vertex.curve][vertex.point];
        for (const std::int32_t k : {place + 1, place - 1}) {
            const TrimmedPoint* point = row_[k];
            if (point != nullptr && point->kind == kind &&
                (holds(point->on) ||
                 (holds(point->across) && kind == TrimmedKind::Crossing)))
                return point;
        }
        return nullptr;
    }

    bool are_neighbours(SegmentNumber one, SegmentNumber other) const
    {
        return std::abs(places_[one.curve][one.point] -
                        places_[other.curve][other.point]) == 1;
    }

    // The first crossing of the result on a curve, or null.
    const TrimmedPoint* crossing_on(std::int32_t curve) const
    {
        return crossings_[curve];
    }

    // The first end or link of the result on a curve, or null.
    const TrimmedPoint* end_on(std::int32_t curve) const { return ends_[curve]; }

private:
    void add(const TrimmedPoint& point)
    {
        if (point.kind == TrimmedKind::Vertex)
            places_[point.on.curve][point.on.point] =
                static_cast<std::int32_t>(row_.size());
        if (point.kind == TrimmedKind::Crossing) {
            for (const std::int32_t curve : {point.on.curve, point.across.curve}) {
                if (crossings_[curve] == nullptr)
                    crossings_[curve] = &point;
            }
        } else if (point.kind != TrimmedKind::Vertex &&
                   ends_[point.on.curve] == nullptr) {
            ends_[point.on.curve] = &point;
        }
        row_.push_back(&point);
    }

    std::vector<std::vector<std::int32_t>> places_;  // index in row_, or `cut`
    std::vector<const TrimmedPoint*> row_;
    std::vector<const TrimmedPoint*> crossings_;  // first crossing on each curve
    std::vector<const TrimmedPoint*> ends_;       // first end or link on each curve
};

// The bound of a stretch: its coordinates, if any point of the curve remains.
struct Bound {
    std::optional<SectionPoint> place;
    bool is_crossing;
};

// Finds the bound of the stretch `first` to `last` of a curve of which other points
// remain. A crossing next to the stretch takes precedence over a link, a link over an
// end.
class StretchBounds {
public:
    StretchBounds(const SectionCurve& curve, const KeptPoints& kept, SegmentNumber first,
                  std::int32_t last)
        : points_{curve.points},
          kept_{kept},
          before_{first.curve, first.point - 1},
          last_{first.curve, last},
          behind_{first.curve, last + 1}
    {
    }

    Bound bound() const
    {
        if (const TrimmedPoint* crossing = point_of(TrimmedKind::Crossing))
            return {crossing->at, true};
        if (const auto vertex = crossing_vertex())
            return {vertex, true};
        if (const TrimmedPoint* link = point_of(TrimmedKind::Link))
            return {link->at, false};
        if (const TrimmedPoint* end = point_of(TrimmedKind::End))
            return {end->at, false};
        return {kept_.at(has_before() ? before_ : behind_), false};
    }

private:
    bool has_before() const { return before_.point >= 0; }
    bool has_behind() const { return behind_.point < std::ssize(points_); }

    const TrimmedPoint* point_of(TrimmedKind kind) const
    {
        const Segments segments{before_.point, last_.point};
        const TrimmedPoint* point =
            has_before() ? kept_.beside(before_, segments, kind) : nullptr;
        return point == nullptr && has_behind() ? kept_.beside(behind_, segments, kind)
                                                : point;
    }

    // The crossing that bounds the stretch, if that crossing is a vertex of the section.
    // Then the result connects the points before and behind the stretch directly, and not
    // by a vertical step.
    std::optional<SectionPoint> crossing_vertex() const
    {
        if (!has_before() || !has_behind() || !kept_.are_neighbours(before_, behind_))
            return std::nullopt;
        const SectionPoint& before = points_[before_.point];
        const SectionPoint& behind = points_[behind_.point];
        if (before.x() == behind.x())
            return std::nullopt;
        return kept_.at(orientation(points_[last_.point], behind, before) == 0 ? before_
                                                                               : behind_);
    }

    std::span<const SectionPoint> points_;
    const KeptPoints& kept_;
    SegmentNumber before_;  // the point in front of the stretch, and its segment
    SegmentNumber last_;    // the last point of the stretch, and the segment behind it
    SegmentNumber behind_;
};

Bound bound_of(const SectionCurve& curve, const KeptPoints& kept, SegmentNumber first,
               std::int32_t last)
{
    if (first.point > 0 || last + 1 < std::ssize(curve.points))
        return StretchBounds{curve, kept, first, last}.bound();
    if (const TrimmedPoint* crossing = kept.crossing_on(first.curve))
        return {crossing->at, true};
    if (const TrimmedPoint* end = kept.end_on(first.curve))
        return {end->at, false};
    return {std::nullopt, false};
}

bool has_crease(SegmentNumber first, std::int32_t last, const CreaseTest& is_on_crease)
{
    for (SegmentNumber at = first; is_on_crease && at.point <= last; ++at.point) {
        if (is_on_crease(at))
            return true;
    }
    return false;
}

CutOut stretch(const SectionCurve& curve, const KeptPoints& kept, SegmentNumber first,
               std::int32_t last, const CreaseTest& is_on_crease)
{
    const Bound bound = bound_of(curve, kept, first, last);
    CutCause cause = curve.is_closed && !bound.place ? CutCause::Closed : CutCause::End;
    if (bound.is_crossing)
        cause = has_crease(first, last, is_on_crease) ? CutCause::Crease : CutCause::Fold;
    return {first.curve, first.point, last, cause, bound.place, {}};
}

void append_stretches(const SectionCurve& curve, std::int32_t number,
                      const KeptPoints& kept, const CreaseTest& is_on_crease,
                      std::vector<CutOut>& result)
{
    const auto count = static_cast<std::int32_t>(curve.points.size());
    for (std::int32_t first = 0; first < count; ++first) {
        if (kept.has(number, first))
            continue;
        std::int32_t last = first;
        while (last + 1 < count && !kept.has(number, last + 1))
            ++last;
        result.push_back(stretch(curve, kept, {number, first}, last, is_on_crease));
        first = last;
    }
}

// Assigns a rule to every stretch. A rule's points lie inside one stretch. A stretch
// without a rule of its own gets the method's general rule.
void name_rules(const Trimmed& trimmed, std::vector<CutOut>& stretches)
{
    for (CutOut& piece : stretches)
        piece.rule = trimmed.rule;
    for (const AppliedRule& rule : trimmed.rules) {
        const auto behind =
            std::upper_bound(stretches.begin(), stretches.end(), rule,
                             [](const AppliedRule& applied, const CutOut& other) {
                                 return applied.curve != other.curve
                                            ? applied.curve < other.curve
                                            : applied.first_point < other.first_point;
                             });
        if (behind != stretches.begin() && (behind - 1)->curve == rule.curve)
            (behind - 1)->rule = rule.rule;
    }
}

}  // namespace

std::string_view name(CutCause cause)
{
    switch (cause) {
        case CutCause::Fold:
            return "fold";
        case CutCause::Crease:
            return "crease";
        case CutCause::End:
            return "end";
        case CutCause::Closed:
            break;
    }
    return "closed";
}

CreaseTest crease_test(const OffsetMesh& offset, const PlaneSection& section)
{
    return [&offset, &section](const SegmentNumber& at) {
        const CrossedEdge& edge = section.edges[static_cast<std::size_t>(at.curve)]
                                               [static_cast<std::size_t>(at.point)];
        const auto is_concave = [&](std::int32_t vertex) {
            return offset.contacts[static_cast<std::size_t>(vertex)].kind ==
                   ContactKind::ConcaveCrease;
        };
        return is_concave(edge.below) || is_concave(edge.above);
    };
}

std::vector<CutOut> cut_out(std::span<const SectionCurve> curves, const Trimmed& trimmed,
                            const CreaseTest& is_on_crease)
{
    const KeptPoints kept{curves, trimmed};
    std::vector<CutOut> result;
    for (std::size_t number = 0; number < curves.size(); ++number)
        append_stretches(curves[number], static_cast<std::int32_t>(number), kept,
                         is_on_crease, result);
    name_rules(trimmed, result);
    return result;
}

}  // namespace endmill
