// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/scallop_between.h"

#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// No cusp, or no point of the surface below it.
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Vec3 ball_centre(const SurfaceTangents& at, double side, double radius)
{
    return at.point + radius * side * unit_normal(at);
}

// Distance from `place` to its foot point on the surface. Newton's method from `start`
// solves (r - place).du = (r - place).dv = 0.
double distance_to_surface(const Surface& surface, const Vec3& place, SurfacePoint start)
{
    constexpr int most_steps = 30;
    // Parameter step at which the iteration stops: the distance is stationary at the foot
    // point, so an error of this size changes it by less than rounding.
    constexpr double last_step = 1e-12;
    for (int step = 0; step < most_steps; ++step) {
        const SurfaceJet jet = surface.jet(start.u, start.v);
        const Vec3 gap = jet.point - place;
        Eigen::Matrix2d slope;
        slope << jet.du.dot(jet.du) + gap.dot(jet.duu),
            jet.du.dot(jet.dv) + gap.dot(jet.duv), jet.du.dot(jet.dv) + gap.dot(jet.duv),
            jet.dv.dot(jet.dv) + gap.dot(jet.dvv);
        const Eigen::Vector2d move =
            -slope.inverse() * Eigen::Vector2d{gap.dot(jet.du), gap.dot(jet.dv)};
        start.u += move.x();
        start.v += move.y();
        if (move.cwiseAbs().maxCoeff() <= last_step)
            return (surface.tangents(start.u, start.v).point - place).norm();
    }
    return nothing;
}

SurfacePoint exchanged(const SurfacePoint& at)
{
    return {at.v, at.u};
}

}  // namespace

double scallop_between(const Surface& surface, const BallCutter& ball,
                       const FeedFrame& frame, const SurfacePoint& partner, double side)
{
    const double R = ball.radius();
    const SurfaceTangents second = surface.tangents(partner.u, partner.v);
    const Vec3 one = frame.jet.point + R * frame.forms.normal;
    const Vec3 other = ball_centre(second, side, R);
    // The cusp lies in two planes: the plane of the circle in which the spheres
    // intersect, and the check plane. `up` is the direction of their common line, and
    // `middle` is the point of the line nearest to the first centre.
    const Vec3 across = other - one;
    const Vec3 up = across.cross(frame.feed).normalized();
    Eigen::Matrix3d planes;
    planes << across.transpose(), frame.feed.transpose(), up.transpose();
    const Vec3 middle =
        one + planes.inverse() * Vec3{across.squaredNorm() / 2,
                                      (frame.jet.point - one).dot(frame.feed), 0};
    const double rise2 = R * R - (middle - one).squaredNorm();
    if (!(rise2 >= 0))
        return nothing;
    const Vec3 down = up.dot(frame.forms.normal) > 0 ? Vec3{-up} : up;
    const Vec3 cusp = middle + std::sqrt(rise2) * down;
    return distance_to_surface(
        surface, cusp, {(frame.at.u + partner.u) / 2, (frame.at.v + partner.v) / 2});
}

std::vector<double> governing_scallops(const Surface& surface, const BallCutter& ball,
                                       const IsoParametricPlan& plan, Parameter direction)
{
    const bool along_u = direction == Parameter::U;
    const Surface marched = along_u ? surface : transposed(surface);
    const double side = tool_side_sign(marched, Vec3::UnitZ());
    std::vector<double> scallops;
    for (const auto& governing : plan.governing) {
        if (!governing)
            continue;
        const SurfacePoint at = along_u ? governing->at : exchanged(governing->at);
        const SurfacePoint partner =
            along_u ? governing->partner : exchanged(governing->partner);
        const FeedFrame frame = feed_frame(at, marched.jet(at.u, at.v), side);
        scallops.push_back(scallop_between(marched, ball, frame, partner, side));
    }
    return scallops;
}

}  // namespace endmill
