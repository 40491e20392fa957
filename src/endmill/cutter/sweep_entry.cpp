// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/sweep_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/cutter/line_stretch.h"

namespace endmill {
namespace {

using Eigen::Vector2d;

// Rise of a move, as a share of its length, below which it is level: its heights are then
// off by no more than that.
constexpr double level_rise = 1e-13;
// Of the lengths that go into a gap: what their rounding makes of it, and of an entry.
constexpr double rounding_share = 1e-15;
// More than a bracketed search of doubles ever needs: it halves at least every other time.
constexpr int most_iterations = 200;
// One step of a search in so many halves the range, for sure progress.
constexpr int steps_per_halving = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();

// The move and the line in the plane: along the move and across it.
struct Plan {
    double length;
    double rise;     // of the whole move
    Vector2d start;  // of the line, from the move's first tip
    Vector2d rate;
    double start_z;  // of the line, above the move's first tip
    double rate_z;
    Vector2d along;  // the move's direction in x and y
};

Plan plan_of(const StraightSweep& sweep, const Line& line)
{
    Plan plan;
    plan.length = sweep.length();
    plan.rise = sweep.to().z() - sweep.from().z();
    plan.along = plan.length > 0
                     ? Vector2d{(sweep.to() - sweep.from()).head<2>() / plan.length}
                     : Vector2d::UnitX();
    const auto turned = [&](const Vec3& v) -> Vector2d {
        return {v.x() * plan.along.x() + v.y() * plan.along.y(),
                v.y() * plan.along.x() - v.x() * plan.along.y()};
    };
    const Vec3 offset = line.origin - sweep.from();
    plan.start = turned(offset);
    plan.rate = turned(line.direction);
    plan.start_z = offset.z();
    plan.rate_z = line.direction.z();
    return plan;
}

Vec3 out_of_plan(const Plan& plan, double along, double across, double up)
{
    return {along * plan.along.x() - across * plan.along.y(),
            along * plan.along.y() + across * plan.along.x(), up};
}

// The upright cylinder that stands at `along` on the move, from the height `bottom` up.
Stretch upright_cylinder(const Plan& plan, double radius, double along, double bottom)
{
    return shared(within_circle(plan.start - Vector2d{along, 0}, plan.rate, radius),
                  where_positive(plan.start_z - bottom, plan.rate_z));
}

// What stands above the upright rectangle under the move, as wide as the cutter and
// `above` the tips.
Stretch upright_slab(const Plan& plan, double radius, double above)
{
    if (plan.length == 0)
        return Stretch::none();
    const double slope = plan.rise / plan.length;
    Stretch slab = where_positive(plan.start_z - above - slope * plan.start.x(),
                                  plan.rate_z - slope * plan.rate.x());
    for (const double side : {-1.0, 1.0})
        slab = shared(
            slab, where_positive(radius + side * plan.start.y(), side * plan.rate.y()));
    slab = shared(slab, where_positive(plan.start.x(), plan.rate.x()));
    return shared(slab, where_positive(plan.length - plan.start.x(), -plan.rate.x()));
}

// Where the line comes into the cutter's upright sides: into the outline of the whole
// move, seen from above.
Stretch within_outline(const Plan& plan, double radius)
{
    Stretch sides;
    for (const double side : {-1.0, 1.0})
        sides = shared(
            sides, where_positive(radius + side * plan.start.y(), side * plan.rate.y()));
    sides = shared(sides, where_positive(plan.start.x(), plan.rate.x()));
    sides = shared(sides, where_positive(plan.length - plan.start.x(), -plan.rate.x()));
    const Stretch first = within_circle(plan.start, plan.rate, radius);
    const Stretch last =
        within_circle(plan.start - Vector2d{plan.length, 0}, plan.rate, radius);
    return spanned(spanned(first, last), sides);
}

// Out of the outline, where the line crosses it.
Vec3 outline_normal(const Plan& plan, double t)
{
    const Vector2d at = plan.start + t * plan.rate;
    const double nearest = std::clamp(at.x(), 0.0, plan.length);
    const Vector2d out = at - Vector2d{nearest, 0};
    return out_of_plan(plan, out.x(), out.y(), 0).normalized();
}

// The ball swept along the segment between its centres.
std::optional<SweepEntry> capsule_entry(const StraightSweep& sweep, const Line& line)
{
    const double R = sweep.cutter().radius();
    const Vec3 lift{0, 0, R};
    const Vec3 d = sweep.to() - sweep.from();
    const Vec3 o = line.origin - sweep.from() - lift;
    const double dd = d.squaredNorm();
    const double dn = d.dot(line.direction);
    const double d_o = d.dot(o);
    const double on = o.dot(line.direction);
    const double a = dd - dn * dn;
    double share = dn >= 0 ? 0 : 1;  // of the segment: whose ball a line along it meets
    if (a > 0) {
        const double b = dd * on - d_o * dn;
        const double c = dd * (o.squaredNorm() - R * R) - d_o * d_o;
        const double h = b * b - a * c;
        if (!(h >= 0))
            return std::nullopt;
        const double t = (-b - std::sqrt(h)) / a;
        share = (d_o + t * dn) / dd;
        if (0 <= share && share <= 1)
            return SweepEntry{t, (o + t * line.direction - share * d) / R};
    }
    const Vec3 from_centre = share > 0.5 ? Vec3{o - d} : o;
    const double b = from_centre.dot(line.direction);
    const double h = R * R - (from_centre - b * line.direction).squaredNorm();
    if (!(h >= 0))
        return std::nullopt;
    const double t = -b - std::sqrt(h);
    return SweepEntry{t, (from_centre + t * line.direction) / R};
}

// The least entry into an upright part that begins before `found`.
std::optional<SweepEntry> sooner(const Plan& plan, const Stretch& upright,
                                 std::optional<SweepEntry> found)
{
    if (upright.is_empty() || (found && found->t <= upright.low))
        return found;
    return SweepEntry{upright.low, std::isfinite(upright.low)
                                       ? outline_normal(plan, upright.low)
                                       : Vec3{-Vec3::UnitZ()}};
}

// Whether the line up to `before` stays below the centres of the ball.
bool stays_below_centres(const StraightSweep& sweep, const Line& line, double before)
{
    const double lowest =
        std::min(sweep.from().z(), sweep.to().z()) + sweep.cutter().radius();
    return line.direction.z() >= 0 &&
           line.origin.z() + before * line.direction.z() < lowest;
}

std::optional<SweepEntry> ball_entry(const StraightSweep& sweep, const Line& line,
                                     double before)
{
    std::optional<SweepEntry> entry = capsule_entry(sweep, line);
    // On the lower half of the capsule's boundary one is on that of the region; and what
    // is upright begins at the centres.
    if ((entry && entry->normal.z() <= 0) || stays_below_centres(sweep, line, before))
        return entry;
    const Plan plan = plan_of(sweep, line);
    const double R = sweep.cutter().radius();
    entry = sooner(plan, upright_cylinder(plan, R, 0, R), entry);
    entry = sooner(plan, upright_cylinder(plan, R, plan.length, plan.rise + R), entry);
    return sooner(plan, upright_slab(plan, R, R), entry);
}

std::optional<SweepEntry> flat_entry(const StraightSweep& sweep, const Line& line)
{
    const Plan plan = plan_of(sweep, line);
    const double R = sweep.cutter().radius();
    const Stretch at_ends[] = {upright_cylinder(plan, R, 0, 0),
                               upright_cylinder(plan, R, plan.length, plan.rise)};
    Stretch whole = spanned(at_ends[0], at_ends[1]);
    whole = spanned(whole, upright_slab(plan, R, 0));
    const bool is_level = std::abs(plan.rise) <= level_rise * plan.length;
    Vec3 normal = -Vec3::UnitZ();
    if (!is_level && plan.length > 0) {
        // Between the two ends the rim sweeps an oblique cylinder.
        const double per_rise = plan.length / plan.rise;
        const Vector2d start = plan.start - Vector2d{per_rise * plan.start_z, 0};
        const Vector2d rate = plan.rate - Vector2d{per_rise * plan.rate_z, 0};
        const double sign = plan.rise > 0 ? 1 : -1;
        Stretch oblique = within_circle(start, rate, R);
        oblique =
            shared(oblique, where_positive(sign * plan.start_z, sign * plan.rate_z));
        oblique = shared(oblique, where_positive(sign * (plan.rise - plan.start_z),
                                                 -sign * plan.rate_z));
        if (!oblique.is_empty() && (whole.is_empty() || oblique.low < whole.low)) {
            const Vector2d out = start + oblique.low * rate;
            normal =
                out_of_plan(plan, out.x(), out.y(), -per_rise * out.x()).normalized();
            return SweepEntry{oblique.low, normal};
        }
    }
    if (whole.is_empty())
        return std::nullopt;
    const double t = whole.low;
    if (!std::isfinite(t))
        return SweepEntry{t, normal};
    // Through the bottom or through the side, whichever the line comes to last.
    const Stretch outline = within_outline(plan, R);
    const double rounding = 1e-12 * (R + plan.length);  // of t, mm
    return SweepEntry{t, outline.low >= t - rounding ? outline_normal(plan, t) : normal};
}

// S - z along a line, a convex function of t where the cutter passes.
struct Gap {
    double value;
    double rate;
    Vec3 normal;  // out of the region
};

Gap gap_at(const StraightSweep& sweep, const Plan& plan, const Line& line, double t)
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
std::optional<SweepEntry> entry_between(const StraightSweep& sweep, const Plan& plan,
                                        const Line& line, Stretch left, bool inside)
{
    const double rounding =
        rounding_share *
        (sweep.cutter().radius() + plan.length + std::abs(left.low) +
         line.origin.lpNorm<Eigen::Infinity>() + sweep.from().lpNorm<Eigen::Infinity>());
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
            if (inside && tangent - t <= rounding && std::isfinite(gap.rate))
                break;
        } else {
            return std::nullopt;  // the least gap is positive
        }
    }
    if (!inside || left.is_empty())
        return std::nullopt;
    const Gap gap = gap_at(sweep, plan, line, left.low);
    const bool is_at_side = !std::isfinite(gap.value);  // just outside, by rounding
    return SweepEntry{left.low, is_at_side ? outline_normal(plan, left.low) : gap.normal};
}

// Whether the line is certain to be outside the region from `from` on down to where it has
// long left it below: a plane that the region lies beyond, near the place at `before`,
// shows most of what a look at S would.
bool is_outside(const StraightSweep& sweep, const Plan& plan, double from, double before)
{
    const double r = sweep.cutter().corner_radius();
    const double flat = sweep.cutter().flat_radius();
    const Vector2d at = plan.start + before * plan.rate;
    const double z = plan.start_z + before * plan.rate_z;
    const double along = std::clamp(at.x(), 0.0, plan.length);
    const double rise = plan.length > 0 ? plan.rise * (along / plan.length) : plan.rise;
    // From the place to the circle of the corner's centres where the cutter is level.
    Vector2d way = Vector2d{along, 0} - at;
    const double distance = way.norm();
    way *= distance > flat ? 1 - flat / distance : 0;
    const double up = std::max(0.0, rise + r - z);
    const double gap = std::sqrt(way.squaredNorm() + up * up);
    if (!(gap > 0))
        return false;
    const double across = way.norm();
    // The support of the region against the way; a slope of the move tilts it.
    const double rate = way.x() * plan.length + up * plan.rise;
    const double share = plan.length > 0 ? along / plan.length : 0;
    const double least = way.x() * along + up * (rise + r) +
                         std::min(-share * rate, (1 - share) * rate) - flat * across -
                         r * gap;
    const double at_before = way.dot(at) + up * z;
    const double at_from =
        at_before + (from - before) * (way.dot(plan.rate) + up * plan.rate_z);
    return at_before < least && at_from < least;
}

std::optional<SweepEntry> corner_entry(const StraightSweep& sweep, const Line& line,
                                       double before)
{
    const Plan plan = plan_of(sweep, line);
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
        if (is_outside(sweep, plan, left.low, before))
            return std::nullopt;
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

}  // namespace

std::optional<SweepEntry> sweep_entry(const StraightSweep& sweep, const Line& line,
                                      double before)
{
    if (!sweep.cutter().is_ball() && !sweep.cutter().is_flat())
        return corner_entry(sweep, line, before);
    const auto entry = sweep.cutter().is_ball() ? ball_entry(sweep, line, before)
                                                : flat_entry(sweep, line);
    return entry && entry->t < before ? entry : std::nullopt;
}

}  // namespace endmill
