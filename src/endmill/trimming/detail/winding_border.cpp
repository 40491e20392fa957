// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/winding_border.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "endmill/trimming/detail/winding_faces.h"

namespace endmill {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;

// The origin of a segment of the arrangement: a segment of a curve (its number), a
// closing line, or a dividing line through an end of an open curve, which only cuts other
// segments there.
struct Label {
    static constexpr std::int32_t closing = -1;
    static constexpr std::int32_t dividing = -2;
    std::int32_t number;  // number of the segment, or `closing` or `dividing`
    // of a closing line of curve k: 3 k, 3 k + 1 or 3 k + 2 for its three parts
    std::int32_t closes;
    // 1 if it runs from the smaller point to the larger, -1 if not; 0 if dividing
    std::int32_t forward;
    friend bool operator==(const Label&, const Label&) = default;
};

// The data of a face.
struct FaceState {
    std::int32_t number = 0;
    bool is_kept = false;
};

using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, Label>;
using Dcel = CGAL::Arr_extended_dcel<Traits, bool, bool, FaceState>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Halfedge = Arrangement::Halfedge_handle;
using Vertex = Arrangement::Vertex_handle;

// An open curve: its end vertices.
struct OpenCurve {
    std::int32_t first;  // vertex
    std::int32_t last;
};

bool is_forward(const Halfedge& edge)
{
    return edge->direction() == CGAL::ARR_LEFT_TO_RIGHT;
}

// The decrease of the index from the left side of `edge` to its right side.
int fall(const Halfedge& edge)
{
    int sum = 0;
    for (const Label& label : edge->curve().data())
        sum += label.forward;
    return is_forward(edge) ? sum : -sum;
}

// The smallest segment number on `edge`; nothing if no segment of a curve lies on it.
std::optional<std::int32_t> carrier(const Halfedge& edge)
{
    std::optional<std::int32_t> least;
    for (const Label& label : edge->curve().data())
        if (label.number >= 0 && (!least || label.number < *least))
            least = label.number;
    return least;
}

// Computes the borders of the kept region with an exact arrangement:
// 1. All segments are inserted, with three closing lines for each open curve and a
//    vertical dividing line through each of its ends. Edges that coincide become one,
//    with the labels of all.
// 2. The index of each face follows from a walk over the edges (winding_faces.h), which
//    also decides which faces are kept.
// 3. The result's edges are those between a kept face on their left and another face,
//    without closing lines and without edges outside the intervals of s of the open
//    curves.
// 4. The edges are linked along the border. First come borders that begin at an edge
//    without predecessor, then the closed ones.
class Winding {
public:
    Winding(const PlanePoints& plane, std::span<const SectionCurve> curves)
        : plane_{plane},
          points_{plane.section().points}
    {
        arrange(curves);
    }

    std::vector<WindingBorder> borders()
    {
        keep();
        std::vector<WindingBorder> borders;
        for (auto edge = arrangement_->halfedges_begin();
             edge != arrangement_->halfedges_end(); ++edge)
            if (is_result(edge) && !previous(edge))
                borders.push_back(border_from(edge, false));
        for (auto edge = arrangement_->halfedges_begin();
             edge != arrangement_->halfedges_end(); ++edge)
            if (is_result(edge) && !edge->data())
                borders.push_back(border_from(edge, true));
        return borders;
    }

private:
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
        // CGAL cannot destroy an arrangement whose construction failed for lack of memory.
        auto made = std::make_unique<Arrangement>();
        try {
            CGAL::insert(*made, segments.begin(), segments.end());
        } catch (...) {
            static_cast<void>(made.release());
            throw;
        }
        arrangement_ = std::move(made);
        for (auto edge = arrangement_->halfedges_begin();
             edge != arrangement_->halfedges_end(); ++edge)
            edge->set_data(false);
    }

    // The index at infinity if all curves are closed. It is -1 if the index rises inwards
    // over the leftmost edge of the outer border, because the outermost curve then runs
    // counter-clockwise; otherwise 0.
    std::int32_t index_outside()
    {
        std::optional<Halfedge> leftmost;
        for (auto edge = arrangement_->halfedges_begin();
             edge != arrangement_->halfedges_end(); ++edge)
            if (edge->face() == arrangement_->unbounded_face() && fall(edge) != 0 &&
                edge->twin()->face() != edge->face() &&
                (!leftmost || lesser_end(edge) < lesser_end(*leftmost)))
                leftmost = edge;
        return leftmost && fall(*leftmost) < 0 ? -1 : 0;
    }

    static ExactPoint lesser_end(const Halfedge& edge)
    {
        return std::min(edge->source()->point(), edge->target()->point());
    }

    void keep()
    {
        FaceRule rule{0, 0, open_.empty() ? index_outside() : 0, !open_.empty()};
        for (auto face = arrangement_->faces_begin(); face != arrangement_->faces_end();
             ++face)
            face->set_data({rule.count++, false});
        rule.outer = arrangement_->unbounded_face()->data().number;
        std::vector<FaceStep> steps;
        for (auto edge = arrangement_->halfedges_begin();
             edge != arrangement_->halfedges_end(); ++edge)
            steps.push_back({edge->face()->data().number,
                             edge->twin()->face()->data().number, fall(edge)});
        const std::vector<bool> is_kept = kept_faces(steps, rule);
        for (auto face = arrangement_->faces_begin(); face != arrangement_->faces_end();
             ++face)
            face->set_data({face->data().number, is_kept[face->data().number]});
    }

    static bool is_border(const Halfedge& edge)
    {
        return edge->face()->data().is_kept && !edge->twin()->face()->data().is_kept;
    }

    bool is_result(const Halfedge& edge) const
    {
        return is_border(edge) && carrier(edge) && is_over_open_curve(edge);
    }

    // An edge lies completely inside or outside, because the dividing lines cut it.
    bool is_over_open_curve(const Halfedge& edge) const
    {
        const auto ends = std::minmax(edge->source()->point(), edge->target()->point());
        return open_.empty() || std::ranges::any_of(open_, [&](const OpenCurve& curve) {
                   const double low = points_[curve.first][0];
                   const double high = points_[curve.last][0];
                   return std::min(low, high) <= ends.first.x() &&
                          ends.second.x() <= std::max(low, high);
               });
    }

    // The edge of the result that follows `edge` along the border of the kept region, if
    // any. Edges between two kept faces are passed by.
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

    WindingBorder border_from(const Halfedge& first, bool is_closed)
    {
        WindingBorder border{{}, is_closed};
        if (!is_closed)
            border.places.push_back(end_place(first->source(), *carrier(first)));
        Halfedge edge = first;
        for (;;) {
            edge->set_data(true);
            const auto following = next(edge);
            if (!following)
                break;
            const std::int32_t segment = *carrier(edge);
            if (segment != *carrier(*following))
                border.places.push_back(
                    inner_place(edge->target()->point(), segment, *carrier(*following)));
            edge = *following;
            if (edge == first)
                break;
        }
        if (!is_closed)
            border.places.push_back(end_place(edge->target(), *carrier(edge)));
        return border;
    }

    // The end vertex of `segment` that lies at `point`, if any.
    std::optional<std::int32_t> vertex_at(const ExactPoint& point,
                                          std::int32_t segment) const
    {
        for (const std::int32_t vertex : {segment, segment + 1})
            if (exact(vertex) == point)
                return vertex;
        return std::nullopt;
    }

    BorderPlace inner_place(const ExactPoint& point, std::int32_t p, std::int32_t q) const
    {
        const auto of_p = vertex_at(point, p);
        const auto of_q = vertex_at(point, q);
        if (of_p || of_q)
            return BorderPlace::vertex(of_p && of_q ? std::min(*of_p, *of_q)
                                       : of_p       ? *of_p
                                                    : *of_q);
        return {TrimmedKind::Crossing, p, q};
    }

    bool is_vertical(std::int32_t segment) const
    {
        return points_[segment][0] == points_[segment + 1][0];
    }

    // The place where the result ends: vertically above or below an end of an open curve.
    BorderPlace end_place(const Vertex& at, std::int32_t segment) const
    {
        const ExactPoint& point = at->point();
        if (const auto vertex = vertex_at(point, segment))
            return BorderPlace::vertex(*vertex);
        for (const OpenCurve& curve : open_)
            for (const std::int32_t end : {curve.first, curve.last}) {
                if (exact(end) == point)
                    return BorderPlace::vertex(end);
                if (!is_vertical(segment) && points_[end][0] == point.x())
                    return {TrimmedKind::Link, segment, end};
            }
        return place_on_vertical(at, segment);
    }

    // The place of an end on a vertical segment: another segment's vertex, or the
    // crossing with a segment that is not vertical.
    BorderPlace place_on_vertical(const Vertex& at, std::int32_t segment) const
    {
        std::int32_t other = segment;
        auto edge = at->incident_halfedges();
        const auto begin = edge;
        do {
            for (const Label& label : edge->curve().data()) {
                if (label.number < 0)
                    continue;
                if (const auto vertex = vertex_at(at->point(), label.number))
                    return BorderPlace::vertex(*vertex);
                if (!is_vertical(label.number))
                    other = label.number;
            }
        } while (++edge != begin);
        return {TrimmedKind::Crossing, segment, other};
    }

    const PlanePoints& plane_;
    std::span<const SectionPoint> points_;
    std::unique_ptr<Arrangement> arrangement_;
    std::vector<OpenCurve> open_;
};

}  // namespace

std::vector<WindingBorder> winding_borders(const PlanePoints& plane,
                                           std::span<const SectionCurve> curves)
{
    return Winding{plane, curves}.borders();
}

}  // namespace endmill
