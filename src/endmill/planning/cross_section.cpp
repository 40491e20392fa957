// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/cross_section.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace endmill {
namespace {

constexpr int most_iterations = 8;
constexpr double most_patches_a_step = 0.3;
constexpr double residual_share = 1e-12;  // of the surface's diagonal
// Length of a partial, as a share of the other one, below which it vanishes.
constexpr double vanishing_share = 1e-10;

}  // namespace

FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, double side)
{
    return feed_frame(at, jet, Vec3{side * unit_normal({jet.point, jet.du, jet.dv})});
}

FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, const Vec3& normal)
{
    FeedFrame frame{at, jet, fundamental_forms(jet, normal), {}, {}, {0, 0}, false};
    const double du = jet.du.norm();
    const double dv = jet.dv.norm();
    const bool pass_is_point = du <= vanishing_share * dv;
    frame.passes_meet = dv <= vanishing_share * du;
    frame.feed = (pass_is_point ? jet.duv : jet.du).normalized();
    frame.cross_feed = normal.cross(frame.feed);
    if (frame.cross_feed.dot(frame.passes_meet ? jet.duv : jet.dv) < 0)
        frame.cross_feed = -frame.cross_feed;
    if (pass_is_point)
        frame.cross.b = frame.cross_feed.dot(jet.dv) / (dv * dv);
    else if (!frame.passes_meet)
        frame.cross = tangent_components(frame.forms, jet, frame.cross_feed);
    return frame;
}

CheckPlanePoint check_plane_point(const Surface& surface, const FeedFrame& frame,
                                  double distance)
{
    const SurfacePoint estimate{frame.at.u + frame.cross.a * distance,
                                frame.at.v + frame.cross.b * distance};
    const double tolerance = residual_share * surface.diagonal();
    const double width_u = surface.patch_width(Parameter::U, frame.at.u);
    const double width_v = surface.patch_width(Parameter::V, frame.at.v);
    SurfacePoint at = estimate;
    for (int iteration = 0; iteration <= most_iterations; ++iteration) {
        const SurfaceTangents tangents = surface.tangents(at.u, at.v);
        const Vec3 chord = tangents.point - frame.jet.point;
        const double along = chord.dot(frame.feed);
        const double across = chord.dot(frame.cross_feed) - distance;
        if (std::max(std::abs(along), std::abs(across)) <= tolerance)
            return {at, true, iteration};

        const double a = tangents.du.dot(frame.feed);
        const double b = tangents.dv.dot(frame.feed);
        const double c = tangents.du.dot(frame.cross_feed);
        const double d = tangents.dv.dot(frame.cross_feed);
        const double determinant = a * d - b * c;
        double step_u = (b * across - d * along) / determinant;
        double step_v = (c * along - a * across) / determinant;
        const double patches =
            std::max(std::abs(step_u) / width_u, std::abs(step_v) / width_v);
        if (!std::isfinite(patches))
            break;
        const double share =
            patches > most_patches_a_step ? most_patches_a_step / patches : 1;
        at.u += share * step_u;
        at.v += share * step_v;
    }
    return {estimate, false, most_iterations};
}

double cross_curvature(const FeedFrame& frame)
{
    return normal_curvature(frame.forms, frame.cross);
}

double cross_curvature_by_chord(const Surface& surface, const FeedFrame& frame,
                                double step)
{
    const SurfacePoint at = check_plane_point(surface, frame, step).at;
    const Vec3 chord = surface.tangents(at.u, at.v).point - frame.jet.point;
    return -2 * frame.forms.normal.dot(chord) / chord.squaredNorm();
}

}  // namespace endmill
