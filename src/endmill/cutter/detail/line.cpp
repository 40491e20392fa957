// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/line.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace endmill {

using Eigen::Vector2d;

LineInterval intersection(const LineInterval& a, const LineInterval& b)
{
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

LineInterval hull(const LineInterval& a, const LineInterval& b)
{
    if (a.is_empty())
        return b;
    if (b.is_empty())
        return a;
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

LineInterval where_not_negative(double value, double rate)
{
    if (rate == 0)
        return value >= 0 ? LineInterval{} : LineInterval::none();
    LineInterval interval;
    (rate > 0 ? interval.low : interval.high) = -value / rate;
    return interval;
}

LineInterval within_circle(const Vector2d& offset, const Vector2d& rate, double radius)
{
    const double a = rate.squaredNorm();
    if (a == 0)
        return offset.squaredNorm() <= radius * radius ? LineInterval{}
                                                       : LineInterval::none();
    // From the point of the line that is nearest to the centre. The usual quadratic
    // formula would lose digits if the line's origin is far away.
    const double nearest = -offset.dot(rate) / a;
    const double distance2 = (offset + nearest * rate).squaredNorm();
    const double rest = radius * radius - distance2;
    if (!(rest >= 0))
        return LineInterval::none();
    const double half = std::sqrt(rest / a);
    return {nearest - half, nearest + half};
}

LineInPlan line_in_plan(const StraightSweep& sweep, const Line& line)
{
    LineInPlan plan;
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

Vec3 out_of_plan(const LineInPlan& plan, double along, double across, double up)
{
    return {along * plan.along.x() - across * plan.along.y(),
            along * plan.along.y() + across * plan.along.x(), up};
}

// The outline is the union of a rectangle and the circles around both ends. It is convex,
// so the hull of the three intervals is the interval in the union.
LineInterval within_outline(const LineInPlan& plan, double radius)
{
    LineInterval sides;
    for (const double side : {-1.0, 1.0})
        sides = intersection(sides, where_not_negative(radius + side * plan.start.y(),
                                                       side * plan.rate.y()));
    sides = intersection(sides, where_not_negative(plan.start.x(), plan.rate.x()));
    sides = intersection(
        sides, where_not_negative(plan.length - plan.start.x(), -plan.rate.x()));
    const LineInterval first = within_circle(plan.start, plan.rate, radius);
    const LineInterval last =
        within_circle(plan.start - Vector2d{plan.length, 0}, plan.rate, radius);
    return hull(hull(first, last), sides);
}

Vec3 outline_normal(const LineInPlan& plan, double t)
{
    const Vector2d at = plan.start + t * plan.rate;
    const double nearest = std::clamp(at.x(), 0.0, plan.length);
    const Vector2d out = at - Vector2d{nearest, 0};
    return out_of_plan(plan, out.x(), out.y(), 0).normalized();
}

}  // namespace endmill
