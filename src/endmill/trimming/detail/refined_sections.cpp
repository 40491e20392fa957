// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/refined_sections.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "endmill/trimming/detail/envelope_trimming.h"
#include "endmill/trimming/detail/trimmed_points.h"

namespace endmill {
namespace {

// Share of the cutter's radius. A point that lies up to this far below the envelope
// counts as a point of the envelope: method 1 finds crossings to some hundredths of the
// radius only.
constexpr double below_envelope = 0.01;
// Share of the cutter's radius: a crossing moves at most this far along s.
constexpr double crossing_reach = 0.5;

std::size_t index(std::int32_t number)
{
    return static_cast<std::size_t>(number);
}

// Finds the height at which the cutter rests over points of one section.
class SectionDrop {
public:
    SectionDrop(const SampledSection& sampled, FinerPieces& finer)
        : sampled_{sampled},
          envelope_{sampled.section.curves},
          finer_{finer}
    {
    }

    // Whether point `k` of a curve lies on the upper envelope, so that its z is the
    // height of a cutter over its s. Both ends of a vertical step count, unless the
    // offset is vertical there: then the cutter passes the part's edge, and every height
    // between the ends is possible.
    bool is_height(const TrimmedCurve& curve, std::size_t k) const
    {
        const auto& points = curve.points;
        const double s = points[k].at.x();
        std::size_t first = k;
        std::size_t last = k;
        while (first > 0 && points[first - 1].at.x() == s)
            --first;
        while (last + 1 < points.size() && points[last + 1].at.x() == s)
            ++last;
        bool is_step = false;
        for (; first <= last; ++first) {
            if (is_upright(points[first]))
                return false;
            is_step = is_step || points[first].kind == TrimmedKind::Link;
        }
        const auto height = envelope_.at(s);
        return height && (is_step ||
                          points[k].at.y() >=
                              *height - below_envelope * sampled_.offset.cutter.radius());
    }

    // The contact found by climbing from the point's sampled contact; for a crossing, the
    // higher one of two.
    std::optional<PartContact> near_contact(const TrimmedPoint& point) const
    {
        const Eigen::Vector2d axis = sampled_.line.axis(point.at.x());
        auto contact = sampled_.drop.climb(place(point.on, point), axis);
        if (point.kind != TrimmedKind::Crossing)
            return contact;
        const auto other = sampled_.drop.climb(place(point.across, point), axis);
        return other && (!contact || other->on.height > contact->on.height) ? other
                                                                            : contact;
    }

    // The highest contact of all over the point's s. Nothing if no contact is known, or
    // if the contact is on an edge and the offset has no contacts on edges.
    std::optional<DropRest> rest(const TrimmedPoint& point) const
    {
        const auto known = near_contact(point);
        return known ? rest_at(point.at.x(), *known) : std::nullopt;
    }

    std::vector<DropRest> kinks(const DropRest& low, const DropRest& high) const
    {
        auto kinks = kinks_between(sampled_.drop, sampled_.line, low, high, finer_);
        std::erase_if(kinks, [&](const DropRest& kink) { return !counts(kink.contact); });
        return kinks;
    }

private:
    std::optional<DropRest> rest_at(double s, const PartContact& known) const
    {
        const PartContact contact =
            sampled_.drop.highest(known, sampled_.line.axis(s), finer_);
        return counts(contact) ? std::optional{DropRest{s, contact}} : std::nullopt;
    }

    bool counts(const PartContact& contact) const
    {
        const OffsetMesh& offset = sampled_.offset;
        const bool has_edges = offset.surface_triangles < offset.mesh.triangles().size();
        return contact.is_inside || has_edges;
    }

    const CrossedEdge& edge(const SegmentNumber& at) const
    {
        return sampled_.section.edges[index(at.curve)][index(at.point)];
    }

    bool is_upright(const TrimmedPoint& point) const
    {
        const auto is_level = [&](std::int32_t vertex) {
            return sampled_.offset.contacts[index(vertex)].normal.z() == 0;
        };
        if (point.kind == TrimmedKind::Crossing || point.kind == TrimmedKind::End)
            return false;
        const CrossedEdge& at =
            edge(point.kind == TrimmedKind::Vertex ? point.on : point.across);
        return is_level(at.below) && is_level(at.above);
    }

    // The approximate contact of a point of the section: interpolated between the
    // contacts at the ends of the mesh edge that the plane crosses.
    PartPlace place(SegmentNumber on, const TrimmedPoint& point) const
    {
        const auto& points = sampled_.section.curves[index(on.curve)].points;
        if (point.kind != TrimmedKind::Vertex &&
            (points[index(on.point + 1)] - point.at).squaredNorm() <
                (points[index(on.point)] - point.at).squaredNorm())
            ++on.point;
        const CrossedEdge& crossed = edge(on);
        const OffsetContact& below = sampled_.offset.contacts[index(crossed.below)];
        const OffsetContact& above = sampled_.offset.contacts[index(crossed.above)];
        const double share = crossed_at(crossed);
        if (below.surface != above.surface)
            return share < 0.5 ? PartPlace{index(below.surface), below.at}
                               : PartPlace{index(above.surface), above.at};
        return {index(below.surface),
                {std::lerp(below.at.u, above.at.u, share),
                 std::lerp(below.at.v, above.at.v, share)}};
    }

    // The share of its edge at which the plane crosses it.
    double crossed_at(const CrossedEdge& crossed) const
    {
        const auto points = sampled_.offset.mesh.points();
        const double below = sampled_.line.frame.across(points[index(crossed.below)]);
        const double above = sampled_.line.frame.across(points[index(crossed.above)]);
        return (sampled_.line.across - below) / (above - below);
    }

    const SampledSection& sampled_;
    EnvelopeHeight envelope_;
    FinerPieces& finer_;
};

// The refined position of a point: the reference point of the cutter at rest.
SectionPoint place_of(const DropRest& rest)
{
    return {rest.s, rest.contact.on.height};
}

// Refines one trimmed curve:
// 1. Every point that lies on the envelope gets the highest contact over its s. Crossings
//    and other points are kept in separate lists.
// 2. Between neighbouring points the search of drop_kinks.h finds the kinks of the
//    height, at which the highest contact changes.
// 3. Each crossing is assigned the nearest free kink within crossing_reach; the vertices
//    between its old and its new position are removed.
// 4. The curve is written in the order of s. Kinks without a crossing become new
//    crossings; crossings without a kink keep their s.
class CurveRefinement {
public:
    CurveRefinement(const SectionDrop& drop, const TrimmedCurve& curve, double reach)
        : curve_{curve},
          crossing_reach_{reach}
    {
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const TrimmedPoint& point = curve.points[k];
            auto rest = drop.is_height(curve, k) ? drop.rest(point) : std::nullopt;
            if (rest)
                greatest_shift_ = std::max(
                    greatest_shift_, std::abs(rest->contact.on.height - point.at.y()));
            if (point.kind == TrimmedKind::Crossing)
                crossings_.push_back({point, std::move(rest), points_.size(), none});
            else
                points_.push_back({point, std::move(rest), false});
        }
        for (std::size_t k = 1; k < points_.size(); ++k)
            add_kinks(drop, k);
        for (std::size_t c = 0; c < crossings_.size(); ++c)
            match(c);
    }

    void add_to(RefinedCurves& result) const
    {
        TrimmedCurve refined{{}, curve_.is_closed};
        const auto add = [&](TrimmedPoint point, const std::optional<DropRest>& rest) {
            ++(rest ? result.refined : result.unrefined);
            if (rest)
                point.at = place_of(*rest);
            append(refined, point);
        };
        for (std::size_t k = 0; k <= points_.size(); ++k) {
            for (const auto& [point, rest] : crossings_in_front_of(k))
                add(point, rest);
            if (k < points_.size() && !points_[k].is_passed)
                add(points_[k].sampled, points_[k].rest);
        }
        result.curves.push_back(std::move(refined));
        result.greatest_shift = std::max(result.greatest_shift, greatest_shift_);
    }

private:
    static constexpr std::size_t none = SIZE_MAX;

    struct Point {
        TrimmedPoint sampled;
        std::optional<DropRest> rest;
        bool is_passed;
    };

    struct Kink {
        DropRest rest;
        std::size_t next;  // number of the point behind it
        std::size_t crossing;
    };

    struct Crossing {
        TrimmedPoint sampled;
        std::optional<DropRest> rest;  // over the crossing's own s
        std::size_t next;
        std::size_t kink;
    };

    void add_kinks(const SectionDrop& drop, std::size_t next)
    {
        const auto& low = points_[next - 1].rest;
        const auto& high = points_[next].rest;
        if (!low || !high || !(low->s < high->s))
            return;
        for (DropRest& kink : drop.kinks(*low, *high))
            kinks_.push_back({std::move(kink), next, none});
    }

    // Assigns a kink to a crossing, and marks the vertices that the crossing passes.
    void match(std::size_t number)
    {
        Crossing& crossing = crossings_[number];
        if (!crossing.rest)
            return;
        const double s = crossing.sampled.at.x();
        double nearest = crossing_reach_;
        for (std::size_t k = 0; k < kinks_.size(); ++k) {
            const double distance = std::abs(kinks_[k].rest.s - s);
            if (kinks_[k].crossing == none && distance < nearest) {
                nearest = distance;
                crossing.kink = k;
            }
        }
        if (crossing.kink == none)
            return;
        Kink& kink = kinks_[crossing.kink];
        kink.crossing = number;
        const auto [first, last] = std::minmax(crossing.next, kink.next);
        for (std::size_t k = first; k < last; ++k)
            points_[k].is_passed = points_[k].sampled.kind == TrimmedKind::Vertex;
    }

    // The crossings between points k - 1 and k at their refined positions, ordered by s.
    std::vector<std::pair<TrimmedPoint, std::optional<DropRest>>> crossings_in_front_of(
        std::size_t k) const
    {
        std::vector<std::pair<TrimmedPoint, std::optional<DropRest>>> found;
        for (const Kink& kink : kinks_)
            if (kink.next == k)
                found.emplace_back(kink.crossing == none
                                       ? new_crossing(k)
                                       : crossings_[kink.crossing].sampled,
                                   kink.rest);
        for (const Crossing& crossing : crossings_)
            if (crossing.next == k && crossing.kink == none)
                found.emplace_back(crossing.sampled, crossing.rest);
        std::ranges::stable_sort(found, {}, [](const auto& crossing) {
            return crossing.second ? crossing.second->s : crossing.first.at.x();
        });
        return found;
    }

    TrimmedPoint new_crossing(std::size_t next) const
    {
        return {{},
                points_[next - 1].sampled.on,
                points_[next].sampled.on,
                TrimmedKind::Crossing};
    }

    const TrimmedCurve& curve_;
    double crossing_reach_;
    std::vector<Point> points_;
    std::vector<Crossing> crossings_;
    std::vector<Kink> kinks_;
    double greatest_shift_ = 0;
};

}  // namespace

RefinedCurves refined(const SampledSection& sampled,
                      const std::vector<TrimmedCurve>& curves, FinerPieces& finer)
{
    const SectionDrop drop{sampled, finer};
    RefinedCurves result;
    const double reach = crossing_reach * sampled.offset.cutter.radius();
    for (const TrimmedCurve& curve : curves) {
        CurveRefinement{drop, curve, reach}.add_to(result);
        sampled.finish(curve.points.size());
    }
    return result;
}

double greatest_shift(const SampledSection& sampled,
                      const std::vector<TrimmedCurve>& curves, double least,
                      FinerPieces& finer)
{
    const SectionDrop drop{sampled, finer};
    for (const TrimmedCurve& curve : curves)
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const TrimmedPoint& point = curve.points[k];
            sampled.finish(1);
            const auto shift = [&](const PartContact& contact) {
                return std::abs(contact.on.height - point.at.y());
            };
            if (!drop.is_height(curve, k))
                continue;
            const auto near_contact = drop.near_contact(point);
            if (!near_contact || shift(*near_contact) <= least)
                continue;
            if (const auto rest = drop.rest(point))
                least = std::max(least, shift(rest->contact));
        }
    return least;
}

}  // namespace endmill
