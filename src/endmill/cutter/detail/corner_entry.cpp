// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/corner_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace endmill {
namespace {

using Eigen::Vector2d;

// Rounding error of a distance, as a share of the lengths that it is computed from.
constexpr double rounding_share = 1e-15;
// Newton steps of the search from outside. It needs three to five; a line that takes more
// grazes the region.
constexpr int most_steps = 24;
// Steps of the bracketed search, which halves the bracket at least every fourth step:
// enough to reach neighbouring doubles.
constexpr int most_iterations = 200;
// Every so many steps of the bracketed search one halves the bracket, for sure progress.
constexpr int steps_per_halving = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();

// A half space that contains the region, made from a place of the line and a place of the
// move. Lengths along its normal are multiplied by `distance`, which saves square roots.
struct HalfSpace {
    Vec3 out;         // normal out of the half space, as long as `distance`
    double distance;  // mm, from the place of the line to the nearest point of the core
    double gap;       // from the place to the surface of the corner; 0 or less inside
    double short_by;  // from the place to the half space; negative inside
    double rate;      // how fast the line approaches the half space
    // Derivatives of f = distance^2 / 2 by the share s of the move and the place t:
    double slope;  // df/ds
    double bend;   // d2f/ds2
    double turn;   // d2f/(ds dt)
};

// A place of the line, and a place of the move from which the half space is made.
struct Look {
    double t;      // mm
    double share;  // share of the move, 0 to 1
};

// The search of `corner_approach`. Every half space moves `low_` forwards: no place of
// the line before it is in the region.
class Approach {
public:
    Approach(const StraightSweep& sweep, const Line& line, double before)
        : flat_{sweep.cutter().flat_radius()},
          corner_{sweep.cutter().corner_radius()},
          before_{before},
          offset_{line.origin - sweep.from() - Vec3{0, 0, corner_}},
          way_{line.direction},
          move_{sweep.to() - sweep.from()},
          move_across2_{move_.head<2>().squaredNorm()},
          scale_{sweep.cutter().radius() + sweep.length() +
                 line.origin.lpNorm<Eigen::Infinity>() +
                 sweep.from().lpNorm<Eigen::Infinity>()}
    {
    }

    CornerApproach run()
    {
        Look look = look_from(std::isfinite(before_) ? before_ : -infinite);
        for (int i = 0; i < most_steps && std::isfinite(look.t) && look.t <= before_;
             ++i) {
            const HalfSpace half = half_space(look);
            const double ahead = look.t - low_;
            if (half.rate > 0) {
                if (half.short_by >= (before_ - look.t) * half.rate)
                    return {Answer::No, {}};
                low_ = std::max(low_, look.t + half.short_by / half.rate);
                const double close = length_rounding(look.t) * half.rate;
                // The place is within the corner radius of the core, and the half space
                // proves that no earlier place is in the region.
                if (half.gap <= close && half.short_by >= -close)
                    return {Answer::Yes, SweepEntry{low_, half.out / half.distance}};
                look = better(look, half);
            } else if (half.short_by > 0 && half.short_by >= -ahead * half.rate) {
                return {Answer::No, {}};
            } else if (ahead > 0) {
                look = look_from(low_);
            } else {
                break;
            }
        }
        return {low_ >= before_ ? Answer::No : Answer::Undecided, {}};
    }

private:
    static constexpr double least_square = std::numeric_limits<double>::min();

    double length_rounding(double t) const
    {
        return rounding_share * (scale_ + std::abs(t));
    }

    // Starts at t, at the nearest place of the move. If t is infinite, a rising line
    // starts at the level of the lowest tip, below which it cannot be in the region.
    Look look_from(double t)
    {
        if (!std::isfinite(t) && way_.z() > 0)
            t = low_ = (std::min(0.0, move_.z()) - corner_ - offset_.z()) / way_.z();
        const double length2 = move_across2_ + move_.z() * move_.z();
        if (!(length2 > least_square))
            return {t, 0};
        return {t, std::clamp((offset_ + t * way_).dot(move_) / length2, 0.0, 1.0)};
    }

    // A Newton step in t and the share of the move. It solves two equations: the distance
    // from the core is the corner radius, and its derivative by the share is 0. If the
    // step leaves the move, or aims at the farthest instead of the nearest share, the
    // share is improved first.
    Look better(const Look& look, const HalfSpace& half) const
    {
        const double size = half.bend * half.rate + half.slope * half.turn;
        double share =
            look.share - (half.slope * half.rate + half.turn * half.gap) / size;
        double step = (half.bend * half.gap - half.slope * half.slope) / size;
        if (!(size > least_square && share >= 0 && share <= 1)) {
            share = look.share;
            if (half.bend > least_square)
                share = std::clamp(share - half.slope / half.bend, 0.0, 1.0);
            step = (half.gap + half.slope * (share - look.share)) / half.rate;
        }
        return {std::clamp(look.t + step, low_, before_), share};
    }

    HalfSpace half_space(const Look& look) const
    {
        // v leads from the centre of the disc to the place. (k v.x, k v.y, q) leads from
        // the nearest point of the disc to the place, or from straight above that point
        // if the place is higher.
        const Vec3 v = offset_ + look.t * way_ - look.share * move_;
        const double d = std::sqrt(v.x() * v.x() + v.y() * v.y());
        const double across = d - flat_;
        const double per_d = across > 0 ? 1 / d : 0;
        const double a = across > 0 ? across : 0;
        const double q = v.z() < 0 ? v.z() : 0;
        const double k = a * per_d;
        HalfSpace half;
        half.out = {k * v.x(), k * v.y(), q};
        half.distance = std::sqrt(a * a + q * q);
        half.rate = -half.out.dot(way_);
        half.slope = -half.out.dot(move_);
        half.gap = half.distance * (half.distance - corner_);
        half.short_by =
            half.gap + std::min(-look.share * half.slope, (1 - look.share) * half.slope);
        const double across_move = (v.x() * move_.x() + v.y() * move_.y()) * per_d;
        const double across_way = (v.x() * way_.x() + v.y() * way_.y()) * per_d;
        const double rise = v.z() < 0 ? move_.z() : 0;
        half.bend = across_move * across_move * (1 - k) + k * move_across2_ + rise * rise;
        half.turn = -across_move * across_way * (1 - k) -
                    k * (way_.x() * move_.x() + way_.y() * move_.y()) - rise * way_.z();
        return half;
    }

    double flat_;
    double corner_;
    double before_;
    double low_ = -infinite;  // no place before is in the region
    Vec3 offset_;  // from the centre of the first disc to the line's origin, mm
    Vec3 way_;
    Vec3 move_;
    double move_across2_;
    double scale_;
};

// The gap S - z between the surface and a place of the line, a convex function of t over
// the outline of the move.
struct Gap {
    double value;
    double rate;
    Vec3 normal;  // of the surface S, out of the region
};

Gap gap_at(const StraightSweep& sweep, const LineInPlan& plan, const Line& line, double t)
{
    const Vec3 at = line.origin + t * line.direction;
    const StraightSweep::Height height = sweep.at(at.x(), at.y());
    const Cutter& cutter = sweep.cutter();
    Vector2d out = plan.start + t * plan.rate - Vector2d{height.along, 0};
    const double distance = out.norm();
    const double across =
        std::min(distance - cutter.flat_radius(), cutter.corner_radius());
    Vec3 normal = -Vec3::UnitZ();
    if (across > 0) {
        // The normal of the corner has the sine across its circle and the cosine
        // downwards.
        const double r = cutter.corner_radius();
        const double sine = across / r;
        const double cosine = std::sqrt((1 - sine) * (1 + sine));
        out *= sine / distance;
        normal = out_of_plan(plan, out.x(), out.y(), -cosine);
    }
    // By the envelope theorem, S has the slope of the cutter that leaves it.
    const double across_rate = normal.dot(line.direction);
    const double rate =
        normal.z() < 0 ? -across_rate / normal.z() : std::copysign(infinite, across_rate);
    return {height.z - at.z(), rate, normal};
}

// The entry in the interval `left`, which contains it if there is one. `inside` states
// whether the upper end is in the region. The gap is convex: its tangent at a place
// outside leads towards the entry and never past it.
std::optional<SweepEntry> entry_between(const StraightSweep& sweep,
                                        const LineInPlan& plan, const Line& line,
                                        LineInterval left, bool inside)
{
    const double length_rounding =
        rounding_share *
        (sweep.cutter().radius() + plan.length + std::abs(left.low) +
         line.origin.lpNorm<Eigen::Infinity>() + sweep.from().lpNorm<Eigen::Infinity>());
    std::optional<Gap> at_low;  // the gap at left.low, once that is final
    for (int i = 1; i < most_iterations && left.high - left.low > length_rounding; ++i) {
        // At the rim S is infinitely steep, so that only halving makes progress.
        const bool halve = !inside || i % steps_per_halving == 0;
        const double t = halve ? left.low + (left.high - left.low) / 2 : left.low;
        const Gap gap = gap_at(sweep, plan, line, t);
        if (gap.value <= 0) {
            inside = true;
            left.high = t;
            continue;
        }
        if (!std::isfinite(gap.value)) {  // just outside the outline, by rounding
            left.low = t;
            continue;
        }
        const double tangent = t - gap.value / gap.rate;
        if (gap.rate > 0) {
            left.high = std::min(left.high, std::isfinite(tangent) ? tangent : t);
        } else if (gap.rate < 0) {
            left.low = std::max(left.low, std::isfinite(tangent) ? tangent : t);
            if (inside && tangent - t <= length_rounding && std::isfinite(gap.rate)) {
                at_low = gap;
                break;
            }
        } else {
            return std::nullopt;  // the least gap is positive: the line misses
        }
    }
    if (!inside || left.is_empty())
        return std::nullopt;
    const Gap gap = at_low ? *at_low : gap_at(sweep, plan, line, left.low);
    const bool is_at_side = !std::isfinite(gap.value);  // just outside, by rounding
    return SweepEntry{left.low, is_at_side ? outline_normal(plan, left.low) : gap.normal};
}

}  // namespace

CornerApproach corner_approach(const StraightSweep& sweep, const Line& line,
                               double before)
{
    return Approach{sweep, line, before}.run();
}

std::optional<SweepEntry> corner_entry(const StraightSweep& sweep, const Line& line,
                                       double before)
{
    if (const CornerApproach approach = corner_approach(sweep, line, before);
        approach.enters != Answer::Undecided)
        return approach.entry;
    const LineInPlan plan = line_in_plan(sweep, line);
    LineInterval left = within_outline(plan, sweep.cutter().radius());
    if (left.is_empty())
        return std::nullopt;
    if (!std::isfinite(left.low)) {  // a vertical line: S is a single number
        const Gap gap = gap_at(sweep, plan, line, 0);
        const LineInterval above = where_not_negative(-gap.value, plan.rate_z);
        return above.is_empty() || above.low >= before
                   ? std::nullopt
                   : std::optional{SweepEntry{above.low, gap.normal}};
    }
    if (left.low >= before)
        return std::nullopt;
    bool inside = false;
    if (before < left.high) {
        // One evaluation at `before` decides most lines. Either the entry comes later, or
        // the tangent there leads to a place that the entry does not precede.
        const Gap gap = gap_at(sweep, plan, line, before);
        inside = gap.value <= 0;
        if (gap.rate < 0 && !inside)
            return std::nullopt;
        left.high = before;
        const double tangent = before - gap.value / gap.rate;
        if (inside && gap.rate < 0 && tangent > left.low)
            return entry_between(sweep, plan, line, {tangent, before}, inside);
    }
    if (gap_at(sweep, plan, line, left.low).value <= 0)
        return SweepEntry{left.low, outline_normal(plan, left.low)};
    return entry_between(sweep, plan, line, left, inside);
}

}  // namespace endmill
