// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/contact_frame.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// 1 + R k and 1 + h k below this count as a concavity that the ball does not fit. The
// covered disc is then longer than 300 times that on a plane.
constexpr double least_stretch = 1e-5;

// Directions of the principal curvatures in an orthonormal tangent frame (x, y), from the
// symmetric matrix of the curvature.
struct PrincipalFrame {
    PrincipalCurvatures k;
    Vec3 e1;
    Vec3 e2;
};

PrincipalFrame principal_frame(const SurfaceJet& jet, const FundamentalForms& forms)
{
    const Vec3 x = jet.du.normalized();
    const Vec3 y = forms.normal.cross(x);
    const TangentVector a = tangent_components(forms, jet, x);
    const TangentVector b = tangent_components(forms, jet, y);
    const double xx = normal_curvature(forms, a);
    const double yy = normal_curvature(forms, b);
    const double xy =
        -(forms.e * a.a * b.a + forms.f * (a.a * b.b + a.b * b.a) + forms.g * a.b * b.b);
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    const double mean = (xx + yy) / 2;
    const double spread = std::hypot((xx - yy) / 2, xy);
    const Vec3 greatest = std::cos(angle) * x + std::sin(angle) * y;
    return {{mean - spread, mean + spread}, greatest.cross(forms.normal), greatest};
}

double half_axis(const BoundProblem& problem, double k)
{
    const double stretch =
        (1 + problem.cutter.radius() * k) * (1 + problem.scallop_height * k);
    return plane_half_width(problem) / std::sqrt(stretch);
}

}  // namespace

ContactPlace contact_place(const BoundedPart& part, std::size_t surface,
                           const SurfacePoint& at)
{
    return {surface, part.surfaces[surface].patch_number(Parameter::U, at.u),
            part.surfaces[surface].patch_number(Parameter::V, at.v), at};
}

std::optional<ContactFrame> contact_frame(const BoundedPart& part,
                                          const BoundProblem& problem,
                                          const ContactPlace& place)
{
    const SurfaceJet jet = part.surfaces[place.surface].jet_in_patch(
        place.i, place.j, place.at.u, place.at.v);
    const SurfaceTangents tangents{jet.point, jet.du, jet.dv};
    if (is_singular(tangents))
        return std::nullopt;
    const FundamentalForms forms = fundamental_forms(jet, part.sides[place.surface]);
    const PrincipalFrame frame = principal_frame(jet, forms);
    const double R = problem.cutter.radius();
    if (1 + R * frame.k.least < least_stretch)
        return std::nullopt;
    const double a1 = half_axis(problem, frame.k.least);
    const double a2 = half_axis(problem, frame.k.greatest);
    return ContactFrame{place.surface,
                        place.at,
                        jet.point + R * forms.normal,
                        frame.e1,
                        frame.e2,
                        frame.k,
                        a1,
                        a2,
                        tangent_components(forms, jet, a1 * frame.e1),
                        tangent_components(forms, jet, a2 * frame.e2)};
}

double widest_strip(const ContactFrame& frame, const BoundProblem& problem)
{
    if (problem.length == BoundedLength::Contact)
        return 2 * std::max(frame.half_axis_1, frame.half_axis_2);
    const double R = problem.cutter.radius();
    return 2 * std::max(frame.half_axis_1 / (1 + R * frame.k.greatest),
                        frame.half_axis_2 / (1 + R * frame.k.least));
}

}  // namespace endmill
