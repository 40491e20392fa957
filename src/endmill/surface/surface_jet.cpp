// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface_jet.h"

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Sine of the angle between the partials below which their cross product is rounding.
constexpr double parallel_sine = 1e-10;

}  // namespace

bool is_singular(const SurfaceTangents& tangents)
{
    const double area = tangents.du.cross(tangents.dv).norm();
    return !(area > parallel_sine * tangents.du.norm() * tangents.dv.norm());
}

Vec3 unit_normal(const SurfaceTangents& tangents)
{
    if (is_singular(tangents))
        throw GeometryError{
            "unit_normal: the partial derivatives are parallel or vanish"};
    return tangents.du.cross(tangents.dv).normalized();
}

}  // namespace endmill
