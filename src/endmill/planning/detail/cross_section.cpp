// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/cross_section.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

constexpr int most_iterations = 8;
constexpr double most_patches_a_step = 0.3;
constexpr double small_step_patches = 0.1;
constexpr double residual_share = 1e-12;  // of the surface's diagonal
// Share of the residual allowed below which an expected one need not be seen.
constexpr double sure_share = 1e-3;

// The linear `estimate` of a place `distance` away, corrected for the surface's bend;
// as it was where the partials are parallel.
SurfacePoint bent_estimate(const SurfacePoint& estimate, const FeedFrame& frame,
                           double distance)
{
    const auto [a, b] = frame.cross;
    const SurfaceJet& jet = frame.jet;
    const Vec3 second = a * a * jet.duu + 2 * a * b * jet.duv + b * b * jet.dvv;
    const Vec3 bend = distance * distance / 2 * second;
    const TangentVector back = tangent_components(frame.forms, jet, bend);
    const SurfacePoint bent{estimate.u - back.a, estimate.v - back.b};
    return std::isfinite(bent.u) && std::isfinite(bent.v) ? bent : estimate;
}

}  // namespace

FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, double side)
{
    return feed_frame(at, jet, Vec3{side * unit_normal({jet.point, jet.du, jet.dv})});
}

FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, const Vec3& normal)
{
    FeedFrame frame{at, jet, fundamental_forms(jet, normal), {}, {}, {0, 0}, false};
    const double du2 = jet.du.squaredNorm();
    const double dv2 = jet.dv.squaredNorm();
    const double vanishing2 = vanishing_partial_share * vanishing_partial_share;
    const bool pass_is_point = du2 <= vanishing2 * dv2;
    frame.passes_meet = dv2 <= vanishing2 * du2;
    frame.feed = (pass_is_point ? jet.duv : jet.du).normalized();
    frame.cross_feed = normal.cross(frame.feed);
    if (frame.cross_feed.dot(frame.passes_meet ? jet.duv : jet.dv) < 0)
        frame.cross_feed = -frame.cross_feed;
    if (pass_is_point)
        frame.cross.b = frame.cross_feed.dot(jet.dv) / dv2;
    else if (!frame.passes_meet)
        frame.cross = tangent_components(frame.forms, jet, frame.cross_feed);
    return frame;
}

CheckPlanePoint check_plane_point(const Surface& surface, const FeedFrame& frame,
                                  double distance, double most_v)
{
    const SurfacePoint estimate{frame.at.u + frame.cross.a * distance,
                                frame.at.v + frame.cross.b * distance};
    const double tolerance = residual_share * surface.diagonal();
    const double width_u = surface.patch_width(Parameter::U, frame.at.u);
    const double width_v = surface.patch_width(Parameter::V, frame.at.v);
    SurfacePoint at = bent_estimate(estimate, frame, distance);
    double residual_before = 0;  // none that counts
    int iteration = 0;
    for (; iteration <= most_iterations; ++iteration) {
        const SurfaceTangents tangents = surface.tangents(at.u, at.v);
        const Vec3 chord = tangents.point - frame.jet.point;
        const double along = chord.dot(frame.feed);
        const double across = chord.dot(frame.cross_feed) - distance;
        const double residual = std::max(std::abs(along), std::abs(across));
        if (residual <= tolerance)
            return {at, true, iteration};

        const double a = tangents.du.dot(frame.feed);
        const double b = tangents.dv.dot(frame.feed);
        const double c = tangents.du.dot(frame.cross_feed);
        const double d = tangents.dv.dot(frame.cross_feed);
        const double per_determinant = 1 / (a * d - b * c);
        const double step_u = (b * across - d * along) * per_determinant;
        const double step_v = (c * along - a * across) * per_determinant;
        const double patches =
            std::max(std::abs(step_u) / width_u, std::abs(step_v) / width_v);
        if (!std::isfinite(patches))
            break;
        const bool is_whole = patches <= most_patches_a_step;
        const double share = is_whole ? 1 : most_patches_a_step / patches;
        at.u += share * step_u;
        at.v += share * step_v;
        // Steps that at least halve from here on, as small or converging ones do, sum to
        // no more than this one.
        const bool halves = iteration == 0 ? patches <= small_step_patches
                                           : residual <= residual_before / 2;
        if (is_whole && halves && at.v - patches * width_v > most_v)
            return {at, false, iteration + 1};
        // Newton's steps square the residual: the next one is known without a look.
        const double ratio = residual / residual_before;
        if (is_whole && residual * ratio * ratio <= sure_share * tolerance)
            return {at, true, iteration + 1};
        residual_before = is_whole ? residual : 0;
    }
    return {estimate, false, std::min(iteration, most_iterations)};
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
