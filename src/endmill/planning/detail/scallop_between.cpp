// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/scallop_between.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Vec3 ball_centre(const SurfaceTangents& at, double side, double radius)
{
    return at.point + radius * side * unit_normal(at);
}

// Distance from `place` to its foot on the surface, sought from `start` by Newton's
// method on (r - place).du = (r - place).dv = 0.
double distance_to_surface(const Surface& surface, const Vec3& place, SurfacePoint start)
{
    constexpr int most_steps = 30;
    constexpr double last_step =
        1e-12;  // of a parameter, far below what moves the result
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
    // The spheres share a circle, which the check plane cuts in two points: on the line
    // through `middle` along `up`, the foot of the first centre in both planes.
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

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace endmill
