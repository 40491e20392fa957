// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/corner_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/cutter/detail/corner_approach.h"
#include "endmill/cutter/detail/line_in_plan.h"

namespace endmill {
namespace {

using Eigen::Vector2d;

// Of the lengths that go into a gap: what their rounding makes of it, and of an entry.
constexpr double rounding_share = 1e-15;
// More than a bracketed search of doubles ever needs: it halves at least every other time.
constexpr int most_iterations = 200;
// One step of a search in so many halves the range, for sure progress.
constexpr int steps_per_halving = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();

// S - z along a line, a convex function of t where the cutter passes.
struct Gap {
    double value;
    double rate;
    Vec3 normal;  // out of the region
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
        // The corner's own normal: across its circle it has the sine and the cosine.
        const double r = cutter.corner_radius();
        const double sine = across / r;
        const double cosine = std::sqrt((1 - sine) * (1 + sine));
        out *= sine / distance;
        normal = out_of_plan(plan, out.x(), out.y(), -cosine);
    }
    // By the envelope theorem S has the slope of the cutter that makes it.
    const double across_rate = normal.dot(line.direction);
    const double rate =
        normal.z() < 0 ? -across_rate / normal.z() : std::copysign(infinite, across_rate);
    return {height.z - at.z(), rate, normal};
}

// The entry in `left`, which holds it if there is one; `inside` tells that the high end
// lies in the region. Tangents from outside come near the entry and never past it.
std::optional<SweepEntry> entry_between(const StraightSweep& sweep,
                                        const LineInPlan& plan, const Line& line,
                                        Stretch left, bool inside)
{
    const double rounding =
        rounding_share *
        (sweep.cutter().radius() + plan.length + std::abs(left.low) +
         line.origin.lpNorm<Eigen::Infinity>() + sweep.from().lpNorm<Eigen::Infinity>());
    std::optional<Gap> at_low;  // at left.low, once there is no better
    for (int i = 1; i < most_iterations && left.high - left.low > rounding; ++i) {
        // At the rim itself S is steep without bound: there only halving helps.
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
            if (inside && tangent - t <= rounding && std::isfinite(gap.rate)) {
                at_low = gap;
                break;
            }
        } else {
            return std::nullopt;  // the least gap is positive
        }
    }
    if (!inside || left.is_empty())
        return std::nullopt;
    const Gap gap = at_low ? *at_low : gap_at(sweep, plan, line, left.low);
    const bool is_at_side = !std::isfinite(gap.value);  // just outside, by rounding
    return SweepEntry{left.low, is_at_side ? outline_normal(plan, left.low) : gap.normal};
}

}  // namespace

std::optional<SweepEntry> corner_entry(const StraightSweep& sweep, const Line& line,
                                       double before)
{
    if (const CornerApproach approach = corner_approach(sweep, line, before);
        approach.is_known)
        return approach.entry;
    const LineInPlan plan = line_in_plan(sweep, line);
    Stretch left = within_outline(plan, sweep.cutter().radius());
    if (left.is_empty())
        return std::nullopt;
    if (!std::isfinite(left.low)) {  // upright: S is one number
        const Gap gap = gap_at(sweep, plan, line, 0);
        const Stretch above = where_positive(-gap.value, plan.rate_z);
        return above.is_empty() || above.low >= before
                   ? std::nullopt
                   : std::optional{SweepEntry{above.low, gap.normal}};
    }
    if (left.low >= before)
        return std::nullopt;
    bool inside = false;
    if (before < left.high) {
        // One look at `before` tells most: either the entry comes later, or the tangent
        // there, which passes below S, leads to a place that the entry does not precede.
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
