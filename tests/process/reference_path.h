// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/vec.h"
#include "endmill/process/feed_plan.h"

// The path REF of docs/methods/ball-end-milling.md, section 7, built from the formula
// of the test surface alone, without the planners and surfaces of the library.
namespace endmill::test {

inline constexpr double reference_radius = 5;

/// The test surface z(X, Y) = 40 g(X/40, Y/40), with the derivatives that a cut along X
/// needs.
struct ReferencePoint {
    Vec3 at;
    Vec3 T;           ///< unit, along X
    Vec3 N;           ///< unit, upwards
    Vec3 across;      ///< T x N
    double spread;    ///< |r_Y x T|, distance between passes a unit of Y
    double k_across;  ///< normal curvature along T x N, positive where convex
    double k_plan;    ///< curvature of the section along X
};

inline ReferencePoint reference_point(double X, double Y)
{
    const double x = X / 40;
    const double y = Y / 40;
    // g = p / q with p = x^3 y - x y^3 and q = x^2 + y^2 + 1/4.
    const double p = x * y * (x * x - y * y);
    const double px = 3 * x * x * y - y * y * y;
    const double py = x * x * x - 3 * x * y * y;
    const double pxx = 6 * x * y;
    const double pxy = 3 * x * x - 3 * y * y;
    const double pyy = -6 * x * y;
    const double q = x * x + y * y + 0.25;
    const double gx = (px - p / q * 2 * x) / q;
    const double gy = (py - p / q * 2 * y) / q;
    const double gxx = (pxx - 4 * x * gx - 2 * p / q) / q;
    const double gyy = (pyy - 4 * y * gy - 2 * p / q) / q;
    const double gxy = (pxy - 2 * x * gy - 2 * y * gx) / q;
    ReferencePoint point;
    point.at = {X, Y, 40 * p / q};
    point.T = Vec3{1, 0, gx}.normalized();
    point.N = Vec3{-gx, -gy, 1}.normalized();
    point.across = point.T.cross(point.N);
    point.spread = Vec3{0, 1, gy}.cross(point.T).norm();
    const double tx = point.across.x();
    const double ty = point.across.y();
    point.k_across =
        -(gxx * tx * tx + 2 * gxy * tx * ty + gyy * ty * ty) / 40 * point.N.z();
    point.k_plan = gxx / 40 / std::pow(1 + gx * gx, 1.5);
    return point;
}

/// Positions of the passes, from -40 to 40, for a cusp of 0.2 mm.
inline std::vector<double> reference_passes()
{
    std::vector<double> passes{-40};
    while (passes.back() < 40) {
        double step = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= 600; ++i) {
            const ReferencePoint point = reference_point(-60 + 0.2 * i, passes.back());
            step = std::min(step, std::sqrt(8 * 0.2 * reference_radius /
                                            (1 + reference_radius * point.k_across)) /
                                      point.spread);
        }
        passes.push_back(std::min(40.0, passes.back() + step));
    }
    return passes;
}

/// One cut from X to its next point; `pick` is the distance in Y to the pass before.
inline SegmentCut reference_cut(double X, double end, double Y, double pick)
{
    const ReferencePoint middle = reference_point((X + end) / 2, Y);
    const auto centre = [&](double at) {
        const ReferencePoint point = reference_point(at, Y);
        return Vec3{point.at + reference_radius * point.N};
    };
    SegmentCut cut;
    cut.length_mm = (centre(end) - centre(X)).norm();
    cut.lambda = std::asin(middle.T.z());
    cut.mu = std::atan2(middle.across.z(), middle.N.z());
    cut.depth_mm =
        20 - middle.at.z() - reference_radius * middle.N.z() + reference_radius;
    cut.previous = pick > 0 ? PreviousPass::Beside : PreviousPass::Edge;
    if (pick > 0) {
        cut.pick_feed_mm =
            pick * middle.spread * (1 + reference_radius * middle.k_across);
        cut.pick_feed_horizontal_mm = *cut.pick_feed_mm * std::cos(*cut.mu);
    }
    return cut;
}

inline std::vector<SegmentCut> reference_cuts()
{
    std::vector<double> passes = reference_passes();
    std::ranges::reverse(passes);
    std::vector<SegmentCut> cuts;
    for (std::size_t pass = 0; pass < passes.size(); ++pass) {
        const double pick = pass == 0 ? 0 : passes[pass - 1] - passes[pass];
        double X = -60;
        for (int number = 1; X < 60; ++number) {
            const ReferencePoint start = reference_point(X, passes[pass]);
            const double step = std::min(10.0, std::sqrt(0.08 / std::abs(start.k_plan)));
            const double end = std::min(60.0, X + step * start.T.x());
            cuts.push_back(reference_cut(X, end, passes[pass], pick));
            cuts.back().pass = static_cast<int>(pass);
            cuts.back().point = number;
            X = end;
        }
    }
    return cuts;
}

}  // namespace endmill::test
