// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/refined_sections.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "endmill/trimming/detail/envelope_height.h"
#include "endmill/trimming/detail/trimmed_points.h"

namespace endmill {
namespace {

// Of the cutter's radius, by which a point may lie below the envelope and still be meant to
// be on it: method 1 sees crossings to some hundredths of it.
constexpr double below_envelope = 0.01;
// Of the cutter's radius: the farthest that a crossing moves along s.
constexpr double crossing_reach = 0.5;

std::size_t index(std::int32_t number)
{
    return static_cast<std::size_t>(number);
}

// Lets the cutter down at points of one section.
class SectionDrop {
public:
    SectionDrop(const SampledSection& sampled, FinerPieces& finer)
        : sampled_{sampled},
          envelope_{sampled.section.curves},
          finer_{finer}
    {
    }

    // Whether the point `k` of a curve stands for the height of a cutter over its s. Of a
    // vertical step both ends do, but where the offset stands upright: where the cutter
    // passes by an edge.
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

    // The highest contact that is uphill from where a point was sampled.
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

    // The highest of all, if the offset has contacts of its kind.
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
        const bool has_edges = offset.sheet_triangles < offset.mesh.triangles().size();
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

    // Where a point on a segment, or a vertex, touches the part as sampled, about.
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

SectionPoint place_of(const DropRest& rest)
{
    return {rest.s, rest.contact.on.height};
}

// A curve on its way to the smooth part: its crossings, and what lies between them.
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
        std::optional<DropRest> rest;  // over its own s
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

    // Finds where a crossing has moved to, and the vertices that it has passed by.
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

    // Crossings, as they are now, between the points k - 1 and k.
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
    for (const TrimmedCurve& curve : curves)
        CurveRefinement{drop, curve, reach}.add_to(result);
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
