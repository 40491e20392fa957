// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/sweep_entry.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/cutter/detail/corner_entry.h"

namespace endmill {
namespace {

using Eigen::Vector2d;

// Rise of a move, as a share of its length, up to which it counts as level. Its heights
// are then off by at most this share.
constexpr double level_rise = 1e-13;
// Rounding error of a place on the line, as a share of the cutter's radius and the length
// of the move.
constexpr double rounding_share = 1e-12;

// Where the line is in the upright cylinder around the place `along` on the move, above
// the height `bottom`.
LineInterval upright_cylinder(const LineInPlan& plan, double radius, double along,
                              double bottom)
{
    return intersection(within_circle(plan.start - Vector2d{along, 0}, plan.rate, radius),
                        where_not_negative(plan.start_z - bottom, plan.rate_z));
}

// Where the line is above the rectangle that the cutter's widest chord sweeps on the
// move, `above` the tips.
LineInterval above_rectangle(const LineInPlan& plan, double radius, double above)
{
    if (plan.length == 0)
        return LineInterval::none();
    const double slope = plan.rise / plan.length;
    LineInterval prism = where_not_negative(plan.start_z - above - slope * plan.start.x(),
                                            plan.rate_z - slope * plan.rate.x());
    for (const double side : {-1.0, 1.0})
        prism = intersection(prism, where_not_negative(radius + side * plan.start.y(),
                                                       side * plan.rate.y()));
    prism = intersection(prism, where_not_negative(plan.start.x(), plan.rate.x()));
    return intersection(prism,
                        where_not_negative(plan.length - plan.start.x(), -plan.rate.x()));
}

// The entry into the capsule: the ball swept along the segment between its centres.
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
    double share = dn >= 0 ? 0 : 1;  // place on the segment, for a line parallel to it
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

// The earlier one of `found` and the entry into an upright part of the region.
std::optional<SweepEntry> sooner(const LineInPlan& plan, const LineInterval& upright,
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

// The region of a ball is the capsule with everything above it: upright cylinders over
// the two end balls, and the part above the segment between their centres.
std::optional<SweepEntry> ball_entry(const StraightSweep& sweep, const Line& line,
                                     double before)
{
    std::optional<SweepEntry> entry = capsule_entry(sweep, line);
    // The lower half of the capsule's boundary is boundary of the region. The upright
    // parts begin at the height of the centres.
    if ((entry && entry->normal.z() <= 0) || stays_below_centres(sweep, line, before))
        return entry;
    const LineInPlan plan = line_in_plan(sweep, line);
    const double R = sweep.cutter().radius();
    entry = sooner(plan, upright_cylinder(plan, R, 0, R), entry);
    entry = sooner(plan, upright_cylinder(plan, R, plan.length, plan.rise + R), entry);
    return sooner(plan, above_rectangle(plan, R, R), entry);
}

// The region of a flat cutter is the union of upright cylinders over the two end discs,
// the part above the rectangle between them, and the oblique cylinder that the rim
// sweeps. It is convex, so the entry is the lowest end of the four intervals.
std::optional<SweepEntry> flat_entry(const StraightSweep& sweep, const Line& line)
{
    const LineInPlan plan = line_in_plan(sweep, line);
    const double R = sweep.cutter().radius();
    const LineInterval at_ends[] = {upright_cylinder(plan, R, 0, 0),
                                    upright_cylinder(plan, R, plan.length, plan.rise)};
    LineInterval whole = hull(at_ends[0], at_ends[1]);
    whole = hull(whole, above_rectangle(plan, R, 0));
    const bool is_level = std::abs(plan.rise) <= level_rise * plan.length;
    Vec3 normal = -Vec3::UnitZ();
    if (!is_level && plan.length > 0) {
        // Between its two ends the rim sweeps an oblique cylinder.
        const double per_rise = plan.length / plan.rise;
        const Vector2d start = plan.start - Vector2d{per_rise * plan.start_z, 0};
        const Vector2d rate = plan.rate - Vector2d{per_rise * plan.rate_z, 0};
        const double sign = plan.rise > 0 ? 1 : -1;
        LineInterval oblique = within_circle(start, rate, R);
        oblique = intersection(
            oblique, where_not_negative(sign * plan.start_z, sign * plan.rate_z));
        oblique = intersection(
            oblique,
            where_not_negative(sign * (plan.rise - plan.start_z), -sign * plan.rate_z));
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
    // The line enters through the side if it crosses the outline last, else through the
    // bottom.
    const LineInterval outline = within_outline(plan, R);
    const double length_rounding = rounding_share * (R + plan.length);
    return SweepEntry{
        t, outline.low >= t - length_rounding ? outline_normal(plan, t) : normal};
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
