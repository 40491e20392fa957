// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/cross_section.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"

// check_plane_point solves eq. (9), (10) by Newton's method:
// 1. It starts at the linear estimate, corrected by the second derivatives of the
//    surface.
// 2. A step is limited to a share of a patch, because a long step may leave the region in
//    which the method converges.
// 3. It ends when the residual is below its tolerance. Newton's steps square the
//    residual, so the residual of the next step can be predicted; if the prediction is
//    far below the tolerance, the last evaluation of the surface is saved.
// 4. It ends early when v is certain to stay beyond a limit, see `most_v`.

namespace endmill {
namespace {

// Most Newton steps. Source: docs/methods/economic-cl-data.md, section 6.
constexpr int most_iterations = 8;
// Longest step, in widths of a patch.
constexpr double most_patches_a_step = 0.3;
// A first step of at most so many widths of a patch is trusted to be in the region of
// convergence.
constexpr double small_step_patches = 0.1;
// Tolerance of the residual, as a share of the surface's diagonal.
constexpr double residual_share = 1e-12;
// A predicted residual below this share of the tolerance is not checked.
constexpr double sure_share = 1e-3;

// The linear `estimate` of the point at `distance`, corrected by the second derivatives
// of the surface. It is not corrected where the partials are parallel.
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
    double residual_before = 0;  // 0 after a shortened step: no prediction is possible
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
        // A converging sequence at least halves its steps. The later steps then add up to
        // at most the present one.
        const bool halves = iteration == 0 ? patches <= small_step_patches
                                           : residual <= residual_before / 2;
        if (is_whole && halves && at.v - patches * width_v > most_v)
            return {at, false, iteration + 1};
        // Predicts the next residual from the last two.
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
