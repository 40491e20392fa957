// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/tangent_condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

Angle angle_between(const Vec3& one, const Vec3& other)
{
    return Angle::radians(std::atan2(one.cross(other).norm(), one.dot(other)));
}

void include_joint(TangentCondition& condition, const Vec3& before, const Vec3& beyond)
{
    require(before.norm() > 0 && beyond.norm() > 0,
            "tangent_conditions: two control points at a border coincide");
    const double ratio = beyond.norm() / before.norm();
    condition.least_ratio = std::min(condition.least_ratio, ratio);
    condition.greatest_ratio = std::max(condition.greatest_ratio, ratio);
    const Angle bend = angle_between(before, beyond);
    if (bend.radians() > condition.worst_bend.radians())
        condition.worst_bend = bend;
}

// The condition at the border between the patches i and i + 1 in u.
TangentCondition condition_at(const Surface& surface, int i, const BorderBreak& measured)
{
    TangentCondition condition{
        {}, std::numeric_limits<double>::infinity(), 0, Angle::radians(0), measured};
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int row = 0; row <= 3; ++row) {
            const BezierPatch& left = surface.patch(i, j);
            const BezierPatch& right = surface.patch(i + 1, j);
            const Vec3 joint = left.control_point(3, row);
            include_joint(condition, joint - left.control_point(2, row),
                          right.control_point(1, row) - joint);
        }
    return condition;
}

// The conditions at the borders of constant u. The borders of constant v are those of the
// transposed surface.
std::vector<TangentCondition> conditions_across_u(const Surface& surface,
                                                  const std::string& name)
{
    const std::vector<BorderBreak> breaks = border_breaks(surface);
    const int rows = surface.patches(Parameter::V);
    std::vector<TangentCondition> conditions;
    for (int i = 0; i + 1 < surface.patches(Parameter::U); ++i) {
        const auto first = breaks.begin() + static_cast<std::ptrdiff_t>(i) * rows;
        const auto worst = std::max_element(
            first, first + rows, [](const BorderBreak& one, const BorderBreak& other) {
                return one.normals.radians() < other.normals.radians();
            });
        conditions.push_back(condition_at(surface, i, *worst));
        const double u = surface.breaks(Parameter::U)[i + 1];
        conditions.back().border = name + "=" + to_text(u);
    }
    return conditions;
}

}  // namespace

std::vector<TangentCondition> tangent_conditions(const Surface& surface)
{
    std::vector<TangentCondition> conditions = conditions_across_u(surface, "u");
    for (TangentCondition& condition : conditions_across_u(transposed(surface), "v")) {
        std::swap(condition.measured.at.u, condition.measured.at.v);
        conditions.push_back(condition);
    }
    return conditions;
}

}  // namespace endmill
