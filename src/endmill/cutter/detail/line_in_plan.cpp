// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/line_in_plan.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace endmill {

using Eigen::Vector2d;

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

Stretch within_outline(const LineInPlan& plan, double radius)
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

Vec3 outline_normal(const LineInPlan& plan, double t)
{
    const Vector2d at = plan.start + t * plan.rate;
    const double nearest = std::clamp(at.x(), 0.0, plan.length);
    const Vector2d out = at - Vector2d{nearest, 0};
    return out_of_plan(plan, out.x(), out.y(), 0).normalized();
}

}  // namespace endmill
