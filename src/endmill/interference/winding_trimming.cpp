// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/winding_trimming.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "endmill/interference/trimmed_points.h"

namespace endmill {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;

// A segment of a curve (its number), of a closing line, or of a line through an end of an open
// curve that only divides others.
struct Label {
    static constexpr std::int32_t closing = -1;
    static constexpr std::int32_t dividing = -2;
    std::int32_t number;   // or one of those
    std::int32_t closes;   // of a closing line: the number of its curve
    std::int32_t forward;  // 1 if it runs from the smaller point to the larger, -1, or 0
    friend bool operator==(const Label&, const Label&) = default;
};

// What is known of a face.
struct FaceState {
    bool is_counted = false;
    int index = 0;
    bool is_kept = false;
};

using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, Label>;
using Dcel = CGAL::Arr_extended_dcel<Traits, bool, bool, FaceState>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Halfedge = Arrangement::Halfedge_handle;
using Face = Arrangement::Face_handle;

// The interval of s between the ends of an open curve.
struct Interval {
    std::int32_t first;  // vertex
    std::int32_t last;
};

bool is_forward(const Halfedge& edge)
{
    return edge->direction() == CGAL::ARR_LEFT_TO_RIGHT;
}

// By how much the index falls from the left of `edge` to its right.
int fall(const Halfedge& edge)
{
    int sum = 0;
    for (const Label& label : edge->curve().data())
        sum += label.forward;
    return is_forward(edge) ? sum : -sum;
}

// The segment that carries `edge`, or nothing if that is no part of a curve.
std::optional<std::int32_t> carrier(const Halfedge& edge)
{
    std::optional<std::int32_t> least;
    for (const Label& label : edge->curve().data())
        if (label.number >= 0 && (!least || label.number < *least))
            least = label.number;
    return least;
}

class Winding {
public:
    Winding(const PlanePoints& plane, std::span<const SectionCurve> curves)
        : plane_{plane},
          points_{plane.section().points},
          made_{plane}
    {
        arrange(curves);
    }

    Trimmed trim()
    {
        count(open_.empty() ? index_outside() : 0);
        keep();
        Trimmed trimmed;
        for (auto edge = arrangement_.halfedges_begin();
             edge != arrangement_.halfedges_end(); ++edge)
            if (is_result(edge) && !previous(edge))
                trimmed.curves.push_back(curve_from(edge, false));
        for (auto edge = arrangement_.halfedges_begin();
             edge != arrangement_.halfedges_end(); ++edge)
            if (is_result(edge) && !edge->data())
                trimmed.curves.push_back(curve_from(edge, true));
        std::erase_if(trimmed.curves,
                      [](const TrimmedCurve& curve) { return curve.points.size() < 2; });
        std::ranges::sort(trimmed.curves, {}, [](const TrimmedCurve& curve) {
            const auto& least = *std::ranges::min_element(curve.points, {}, place);
            return place(least);
        });
        return trimmed;
    }

private:
    static std::pair<double, double> place(const TrimmedPoint& point)
    {
        return {point.at[0], point.at[1]};
    }

    ExactPoint exact(std::int32_t vertex) const
    {
        return {points_[vertex][0], points_[vertex][1]};
    }

    void arrange(std::span<const SectionCurve> curves)
    {
        std::vector<Traits::Curve_2> segments;
        const auto add = [&](const ExactPoint& from, const ExactPoint& to, Label label) {
            if (from == to)
                return;
            if (label.number != Label::dividing)
                label.forward = from < to ? 1 : -1;
            segments.emplace_back(SegmentTraits::Curve_2{from, to}, label);
        };
        Kernel::FT lowest = 0;
        Kernel::FT highest = 0;
        for (const SectionPoint& point : points_) {
            lowest = std::min<Kernel::FT>(lowest, point[1]);
            highest = std::max<Kernel::FT>(highest, point[1]);
        }
        lowest -= 1;
        highest += 1;
        std::int32_t begin = 0;
        for (std::size_t k = 0; k < curves.size(); ++k) {
            const std::int32_t end = plane_.section().ends[k];
            for (std::int32_t i = begin; i + 1 < end; ++i)
                add(exact(i), exact(i + 1), {i, 0, 0});
            if (!curves[k].is_closed && begin < end) {
                const ExactPoint first = exact(begin);
                const ExactPoint last = exact(end - 1);
                const ExactPoint below_first{first.x(), lowest};
                const ExactPoint below_last{last.x(), lowest};
                const Label closing{Label::closing, static_cast<std::int32_t>(3 * k), 0};
                add(last, below_last, closing);
                add(below_last, below_first, {closing.number, closing.closes + 1, 0});
                add(below_first, first, {closing.number, closing.closes + 2, 0});
                add(below_first, {first.x(), highest}, {Label::dividing, 0, 0});
                add(below_last, {last.x(), highest}, {Label::dividing, 0, 0});
                open_.push_back({begin, end - 1});
            }
            begin = end;
        }
        CGAL::insert(arrangement_, segments.begin(), segments.end());
        for (auto edge = arrangement_.halfedges_begin();
             edge != arrangement_.halfedges_end(); ++edge)
            edge->set_data(false);
    }

    template <typename Visit>
    void visit_border(Face face, const Visit& visit)
    {
        const auto go_round = [&](Arrangement::Ccb_halfedge_circulator edge) {
            const auto begin = edge;
            do {
                visit(Halfedge{edge});
            } while (++edge != begin);
        };
        for (auto border = face->outer_ccbs_begin(); border != face->outer_ccbs_end();
             ++border)
            go_round(*border);
        for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole)
            go_round(*hole);
    }

    // The index at infinity where all curves are closed.
    int index_outside()
    {
        std::optional<Halfedge> leftmost;
        visit_border(arrangement_.unbounded_face(), [&](const Halfedge& edge) {
            if (fall(edge) != 0 && edge->twin()->face() != edge->face() &&
                (!leftmost || lesser_end(edge) < lesser_end(*leftmost)))
                leftmost = edge;
        });
        return leftmost && fall(*leftmost) < 0 ? -1 : 0;
    }

    static ExactPoint lesser_end(const Halfedge& edge)
    {
        return std::min(edge->source()->point(), edge->target()->point());
    }

    // Counts the indices of all faces from that outside.
    void count(int outside)
    {
        const Face outer = arrangement_.unbounded_face();
        outer->set_data({true, outside, false});
        std::vector<Face> open{outer};
        while (!open.empty()) {
            const Face face = open.back();
            open.pop_back();
            const int index = face->data().index;
            visit_border(face, [&](const Halfedge& edge) {
                const Face next = edge->twin()->face();
                if (next->data().is_counted)
                    return;
                next->set_data({true, index - fall(edge), false});
                open.push_back(next);
            });
        }
    }

    void keep()
    {
        const auto set_kept = [](const Face& face) {
            FaceState state = face->data();
            state.is_kept = true;
            face->set_data(state);
        };
        if (open_.empty()) {
            for (auto face = arrangement_.faces_begin(); face != arrangement_.faces_end();
                 ++face)
                if (face->data().index >= 0)
                    set_kept(face);
            return;
        }
        std::vector<Face> open{arrangement_.unbounded_face()};
        set_kept(open.back());
        while (!open.empty()) {
            const Face face = open.back();
            open.pop_back();
            visit_border(face, [&](const Halfedge& edge) {
                const Face next = edge->twin()->face();
                if (next->data().index < 0 || next->data().is_kept)
                    return;
                set_kept(next);
                open.push_back(next);
            });
        }
    }

    static bool is_border(const Halfedge& edge)
    {
        return edge->face()->data().is_kept && !edge->twin()->face()->data().is_kept;
    }

    bool is_result(const Halfedge& edge) const
    {
        return is_border(edge) && carrier(edge) && is_in_interval(edge);
    }

    // The dividing lines keep an edge from being in part outside.
    bool is_in_interval(const Halfedge& edge) const
    {
        const auto ends = std::minmax(edge->source()->point(), edge->target()->point());
        return open_.empty() || std::ranges::any_of(open_, [&](const Interval& interval) {
                   const double low = points_[interval.first][0];
                   const double high = points_[interval.last][0];
                   return std::min(low, high) <= ends.first.x() &&
                          ends.second.x() <= std::max(low, high);
               });
    }

    // The edge of the result that follows the border of what is kept, if any.
    std::optional<Halfedge> next(const Halfedge& edge) const
    {
        Halfedge following = edge->next();
        while (!is_border(following))
            following = following->twin()->next();
        return is_result(following) ? std::optional{following} : std::nullopt;
    }

    std::optional<Halfedge> previous(const Halfedge& edge) const
    {
        Halfedge leading = edge->prev();
        while (!is_border(leading))
            leading = leading->twin()->prev();
        return is_result(leading) ? std::optional{leading} : std::nullopt;
    }

    TrimmedCurve curve_from(const Halfedge& first, bool is_closed)
    {
        TrimmedCurve curve;
        if (!is_closed)
            append(curve, end_point(first->source()->point(), *carrier(first)));
        Halfedge edge = first;
        for (;;) {
            edge->set_data(true);
            const auto following = next(edge);
            if (!following)
                break;
            const std::int32_t segment = *carrier(edge);
            if (segment != *carrier(*following))
                append(curve, inner_point(edge->target()->point(), segment,
                                          *carrier(*following)));
            edge = *following;
            if (edge == first)
                break;
        }
        if (!is_closed)
            append(curve, end_point(edge->target()->point(), *carrier(edge)));
        else
            close(curve);
        return curve;
    }

    static void close(TrimmedCurve& curve)
    {
        auto& points = curve.points;
        curve.is_closed = true;
        if (points.size() > 1 && points.front().at == points.back().at)
            points.pop_back();
        std::rotate(points.begin(), std::ranges::min_element(points, {}, place),
                    points.end());
        if (points.size() > 1)
            points.push_back(points.front());
    }

    // The vertex of `segment` that lies at `point`.
    std::optional<std::int32_t> vertex_at(const ExactPoint& point,
                                          std::int32_t segment) const
    {
        for (const std::int32_t vertex : {segment, segment + 1})
            if (exact(vertex) == point)
                return vertex;
        return std::nullopt;
    }

    TrimmedPoint inner_point(const ExactPoint& point, std::int32_t p,
                             std::int32_t q) const
    {
        const auto of_p = vertex_at(point, p);
        const auto of_q = vertex_at(point, q);
        if (of_p || of_q)
            return made_.vertex(of_p && of_q ? std::min(*of_p, *of_q)
                                : of_p       ? *of_p
                                             : *of_q);
        return made_.crossing(p, q);
    }

    // Where the result ends: straight above or below an end of an open curve.
    TrimmedPoint end_point(const ExactPoint& point, std::int32_t segment) const
    {
        if (const auto vertex = vertex_at(point, segment))
            return made_.vertex(*vertex);
        for (const Interval& interval : open_) {
            for (const std::int32_t end : {interval.first, interval.last}) {
                const double s = points_[end][0];
                if (s != point.x())
                    continue;
                if (points_[segment][0] == points_[segment + 1][0])  // the end is on it
                    return made_.vertex(end);
                return made_.link(segment, end);
            }
        }
        return inner_point(point, segment, segment);
    }

    const PlanePoints& plane_;
    std::span<const SectionPoint> points_;
    Arrangement arrangement_;
    TrimmedPoints made_;
    std::vector<Interval> open_;
};

}  // namespace

Trimmed winding_trimming(std::span<const SectionCurve> curves,
                         const TrimmingOptions& /*options*/)
{
    const PlanePoints plane{curves};
    return Winding{plane, curves}.trim();
}

}  // namespace endmill
