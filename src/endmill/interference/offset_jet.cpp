// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/offset_jet.h"

#include <cmath>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// Below, H is lost in the rounding of N long before it is undefined.
constexpr double least_level_part = 1e-6;

// A contact's point or normal with its partials.
struct Varying {
    Vec3 value;
    Vec3 du;
    Vec3 dv;
};

// The unit vector of a varying vector.
Varying unit(const Varying& vector)
{
    const double length = vector.value.norm();
    const Vec3 direction = vector.value / length;
    const auto turned = [&](const Vec3& partial) -> Vec3 {
        return (partial - partial.dot(direction) * direction) / length;
    };
    return {direction, turned(vector.du), turned(vector.dv)};
}

Varying normal_of(const SurfaceJet& jet, double side)
{
    return unit({side * jet.du.cross(jet.dv),
                 side * (jet.duu.cross(jet.dv) + jet.du.cross(jet.duv)),
                 side * (jet.duv.cross(jet.dv) + jet.du.cross(jet.dvv))});
}

std::optional<SurfaceTangents> offset_of(const Varying& point, const Varying& normal,
                                         const Cutter& cutter)
{
    const double r = cutter.corner_radius();
    SurfaceTangents offset{point.value + r * normal.value, point.du + r * normal.du,
                           point.dv + r * normal.dv};
    if (cutter.is_ball())
        return offset;
    if (normal.value.head<2>().norm() < least_level_part)
        return std::nullopt;
    const auto level = [](const Vec3& vector) { return Vec3{vector.x(), vector.y(), 0}; };
    const Varying out = unit({level(normal.value), level(normal.du), level(normal.dv)});
    offset.point += cutter.flat_radius() * out.value;
    offset.du += cutter.flat_radius() * out.du;
    offset.dv += cutter.flat_radius() * out.dv;
    return offset;
}

}  // namespace

std::optional<SurfaceTangents> offset_jet(const SurfaceJet& jet, double side,
                                          const Cutter& cutter)
{
    if (is_singular({jet.point, jet.du, jet.dv}))
        return std::nullopt;
    return offset_of({jet.point, jet.du, jet.dv}, normal_of(jet, side), cutter);
}

std::optional<SurfaceTangents> turned_offset_jet(const SurfaceJet& jet, double side,
                                                 Parameter along, double angle,
                                                 const Cutter& cutter)
{
    if (is_singular({jet.point, jet.du, jet.dv}))
        return std::nullopt;
    const bool along_u = along == Parameter::U;
    const Varying surface_normal = normal_of(jet, side);
    const Vec3& first = along_u ? jet.du : jet.dv;
    const Vec3& second = along_u ? jet.duu : jet.dvv;
    const Vec3& normal = surface_normal.value;
    const Vec3& normal_along = along_u ? surface_normal.du : surface_normal.dv;
    const Varying tangent = unit({first, second, Vec3::Zero()});
    const Vec3 across = tangent.value.cross(normal);
    const Vec3 across_along =
        tangent.du.cross(normal) + tangent.value.cross(normal_along);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return offset_of({jet.point, first, Vec3::Zero()},
                     {c * normal + s * across, c * normal_along + s * across_along,
                      c * across - s * normal},
                     cutter);
}

}  // namespace endmill
