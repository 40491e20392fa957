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

double patch_width(const Surface& surface, Parameter along, double parameter)
{
    const int number = surface.patch_number(along, parameter);
    return surface.breaks(along)[number + 1] - surface.breaks(along)[number];
}

}  // namespace

FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, double side)
{
    FeedFrame frame{at, jet, fundamental_forms(jet, side), jet.du.normalized(), {}, {}};
    frame.cross_feed = frame.forms.normal.cross(frame.feed);
    if (frame.cross_feed.dot(jet.dv) < 0)
        frame.cross_feed = -frame.cross_feed;
    frame.cross = tangent_components(frame.forms, jet, frame.cross_feed);
    return frame;
}

CheckPlanePoint check_plane_point(const Surface& surface, const FeedFrame& frame,
                                  double distance)
{
    const SurfacePoint estimate{frame.at.u + frame.cross.a * distance,
                                frame.at.v + frame.cross.b * distance};
    const double tolerance = residual_share * surface.diagonal();
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
            std::max(std::abs(step_u) / patch_width(surface, Parameter::U, at.u),
                     std::abs(step_v) / patch_width(surface, Parameter::V, at.v));
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
