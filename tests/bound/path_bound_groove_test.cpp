// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/path_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "revolved_surfaces.h"

// The integral of one over the widest strip is no lower bound: grooves that one pass covers
// refute it. The bound of the library stays below the length of that pass.
// Source: docs/methods/path-length-bound.md, section 4.
namespace endmill {
namespace {

using std::numbers::pi;

// A groove of circular section along a helix; theta = 0 is the line nearest to the axis.
struct HelicalGroove {
    double spine = 19;   // radius of the helix
    double pitch = 13;   // of the helix
    double section = 9;  // radius of the groove
    double R = 7.5;
    double h = 0.5;

    double rise() const { return pitch / (2 * pi); }
    double speed() const { return std::hypot(spine, rise()); }
    double curvature() const { return spine / (speed() * speed()); }
    double torsion() const { return rise() / (speed() * speed()); }

    // Half the angle of the section that a ball at theta = 0 covers.
    double half_angle() const
    {
        const double y = section - h;
        const double c = section - R;
        return std::acos((y * y + c * c - R * R) / (2 * y * c));
    }

    // The point at distance r from the spine, at angle t of the helix.
    Vec3 point(double t, double theta, double r) const
    {
        const Vec3 inwards{-std::cos(t), -std::sin(t), 0};
        const Vec3 binormal{rise() * std::sin(t) / speed(),
                            -rise() * std::cos(t) / speed(), spine / speed()};
        return Vec3{spine * std::cos(t), spine * std::sin(t), rise() * t} +
               r * (std::cos(theta) * inwards + std::sin(theta) * binormal);
    }

    // Length of the contact line theta = 0 in one turn.
    double pass_per_turn() const
    {
        return 2 * pi * speed() *
               std::hypot(1 - section * curvature(), section * torsion());
    }

    // Area of the groove in one turn.
    double area_per_turn() const
    {
        const double alpha = half_angle();
        return 2 * pi * speed() *
               (2 * alpha * section -
                2 * section * section * curvature() * std::sin(alpha));
    }

    double widest_strip() const { return 2 * section * half_angle(); }
};

// The groove over some turns as bicubic patches with its points, tangents and twists.
Surface groove_surface(const HelicalGroove& groove, double turns)
{
    const int along = static_cast<int>(std::lround(24 * turns));
    constexpr int across = 6;
    const double alpha = groove.half_angle();
    const double step_t = 2 * pi * turns / along;
    const double step_theta = 2 * alpha / across;
    constexpr double e = 1e-4;  // step of the differences
    const auto point = [&](double t, double theta) {
        return groove.point(t, theta, groove.section);
    };
    const auto corner = [&](int i, int j) -> FergusonPatch::Corner {
        const double t = i * step_t;
        const double theta = -alpha + j * step_theta;
        const auto du = [&](double at) -> Vec3 {
            return (point(t + e, at) - point(t - e, at)) / (2 * e) * step_t;
        };
        const Vec3 dv =
            (point(t, theta + e) - point(t, theta - e)) / (2 * e) * step_theta;
        return {point(t, theta), du(theta), dv,
                (du(theta + e) - du(theta - e)) / (2 * e) * step_theta};
    };
    std::vector<double> u;
    std::vector<double> v;
    for (int i = 0; i <= along; ++i)
        u.push_back(i);
    for (int j = 0; j <= across; ++j)
        v.push_back(j);
    std::vector<BezierPatch> patches;
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < along; ++i)
            patches.push_back(
                bezier_from_ferguson({{corner(i, j), corner(i + 1, j), corner(i, j + 1),
                                       corner(i + 1, j + 1)}}));
    return {u, v, patches};
}

TEST(HelicalGroove, IsCoveredByOnePassShorterThanTheIntegral)
{
    const HelicalGroove groove;
    EXPECT_NEAR(groove.half_angle(), 0.773190106947, 1e-11);
    EXPECT_NEAR(10 * groove.pass_per_turn(), 641.626, 0.001);
    const double integral = 10 * groove.area_per_turn() / groove.widest_strip();
    EXPECT_NEAR(integral, 693.061, 0.001);
    EXPECT_GT(integral - 3.22523, 10 * groove.pass_per_turn());
    // Every raised point is within R of a centre of the pass.
    double farthest = 0;
    for (int k = -100; k <= 100; ++k) {
        const Vec3 raised =
            groove.point(0, groove.half_angle() * k / 100, groove.section - groove.h);
        double nearest = 100;
        for (double t = -0.6; t <= 0.6; t += 1e-3)
            nearest = std::min(
                nearest, (raised - groove.point(t, 0, groove.section - groove.R)).norm());
        farthest = std::max(farthest, nearest);
    }
    EXPECT_NEAR(farthest, 7.49973, 1e-4);
    EXPECT_LT(farthest, groove.R);
}

TEST(HelicalGroove, HasABoundBelowThePassThatCoversIt)
{
    const HelicalGroove groove;
    constexpr double turns = 1.5;
    const std::vector<Surface> surfaces{groove_surface(groove, turns)};
    // The normal on the side of the spine.
    const SurfaceTangents at = surfaces[0].tangents(3, 3);
    const Vec3 to_spine = groove.point(2 * pi / 24 * 3, 0, 0) - at.point;
    const std::vector<double> sides{unit_normal(at).dot(to_spine) > 0 ? 1.0 : -1.0};
    BoundProblem problem{BallCutter{groove.R}, groove.h};
    problem.tool = CoveringTool::Ball;
    EstimateOptions options;
    options.node_spacing = 3.8;
    options.random_places = 3000;
    const PathBound bound = path_bound(surfaces, sides, problem, options);
    const double pass = turns * groove.pass_per_turn();
    ASSERT_TRUE(bound.bound_mm);
    EXPECT_LE(*bound.bound_mm, pass);
    EXPECT_GE(*bound.bound_mm, 0.95 * pass);
}

// The groove around a wheel with a level axis, which an upright tool reaches.
TEST(WheelGroove, HasABoundBelowThePassThatCoversIt)
{
    constexpr double spine = 13;
    constexpr double section = 10;
    constexpr double R = 9.8;
    constexpr double h = 0.055;
    constexpr double alpha = 0.752810867085043;
    Nurbs nurbs = test::torus(spine, section,
                              {pi / 2 - pi / 3, pi / 2 + pi / 3, pi - alpha, pi + alpha});
    for (Vec3& point : nurbs.control_points)
        point = {point.x(), -point.z(), point.y()};
    const test::SidedSurfaces wheel{{nurbs_surface(nurbs)}};
    EstimateOptions options;
    options.node_spacing = 1.4;
    options.random_places = 2000;
    const PathBound bound =
        path_bound(wheel.surfaces, wheel.sides, {BallCutter{R}, h}, options);
    const double pass = (spine - section) * 2 * pi / 3;
    const double integral = (spine - section * std::sin(alpha) / alpha) * 2 * pi / 3;
    EXPECT_NEAR(integral, 8.20612, 1e-5);
    EXPECT_GT(integral - 0.85995, pass);
    ASSERT_TRUE(bound.bound_mm);
    EXPECT_LE(*bound.bound_mm, pass);
    EXPECT_GE(*bound.bound_mm, 0.85 * pass);
}

}  // namespace
}  // namespace endmill
