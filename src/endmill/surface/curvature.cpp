// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/curvature.h"

#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {

FundamentalForms fundamental_forms(const SurfaceJet& jet, double side)
{
    return fundamental_forms(jet, Vec3{side * unit_normal({jet.point, jet.du, jet.dv})});
}

FundamentalForms fundamental_forms(const SurfaceJet& jet, const Vec3& normal)
{
    return {jet.du.dot(jet.du),
            jet.du.dot(jet.dv),
            jet.dv.dot(jet.dv),
            normal.dot(jet.duu),
            normal.dot(jet.duv),
            normal.dot(jet.dvv),
            normal};
}

// Solves the normal equations of a du + b dv = direction.
TangentVector tangent_components(const FundamentalForms& forms, const SurfaceJet& jet,
                                 const Vec3& direction)
{
    const auto& [E, F, G, e, f, g, normal] = forms;
    const double along_u = direction.dot(jet.du);
    const double along_v = direction.dot(jet.dv);
    const double determinant = E * G - F * F;
    return {(G * along_u - F * along_v) / determinant,
            (E * along_v - F * along_u) / determinant};
}

double normal_curvature(const FundamentalForms& forms, const TangentVector& unit_tangent)
{
    const auto [a, b] = unit_tangent;
    return -(forms.e * a * a + 2 * forms.f * a * b + forms.g * b * b);
}

PrincipalCurvatures principal_curvatures(const FundamentalForms& forms)
{
    const auto& [E, F, G, e, f, g, normal] = forms;
    // In the orthonormal frame with x along du, the second form is a symmetric matrix,
    // and H^2 - K is a sum of squares. So no digits cancel at an umbilic.
    const double across = std::sqrt((E * G - F * F) / E);
    const double shear = F / E;
    const double xx = e / E;
    const double xy = (f - shear * e) / (std::sqrt(E) * across);
    const double yy = (g - 2 * shear * f + shear * shear * e) / (across * across);
    const double mean = (xx + yy) / 2;
    const double spread = std::hypot((xx - yy) / 2, xy);
    return {-(mean + spread), -(mean - spread)};
}

double curve_curvature(const Vec3& first, const Vec3& second)
{
    const double speed = first.norm();
    return first.cross(second).norm() / (speed * speed * speed);
}

}  // namespace endmill
