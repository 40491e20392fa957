// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_point.h"

#include <Eigen/Geometry>

namespace endmill {

// The derivative of n = a / |a| is (a' - n (n . a')) / |a|, for a = q_u x q_v.
RaisedJet raised_jet(const BoundedPart& part, std::size_t surface, const SurfacePoint& at,
                     double height)
{
    const SurfaceJet jet = part.surfaces[surface].jet(at.u, at.v);
    const Vec3 across = jet.du.cross(jet.dv);
    const double area = across.norm();
    if (is_singular({jet.point, jet.du, jet.dv}, across))
        return {jet.point, jet.du, jet.dv, 0, jet.du, jet.dv};
    const Vec3 normal = across / area;
    const double raise = part.sides[surface] * height;
    const auto raised = [&](const Vec3& tangent, const Vec3& change) -> Vec3 {
        return tangent + raise / area * (change - normal.dot(change) * normal);
    };
    return {jet.point + raise * normal,
            raised(jet.du, jet.duu.cross(jet.dv) + jet.du.cross(jet.duv)),
            raised(jet.dv, jet.duv.cross(jet.dv) + jet.du.cross(jet.dvv)),
            area,
            jet.du,
            jet.dv};
}

RaisedPlace raised_place(const BoundedPart& part, std::size_t surface,
                         const SurfacePoint& at, double height)
{
    const SurfaceTangents tangents = part.surfaces[surface].tangents(at.u, at.v);
    const Vec3 across = tangents.du.cross(tangents.dv);
    const double area = across.norm();
    if (is_singular(tangents, across))
        return {tangents.point, 0};
    return {tangents.point + part.sides[surface] * height / area * across, area};
}

}  // namespace endmill
