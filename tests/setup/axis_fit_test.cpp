// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_fit.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

using std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A problem with few cells and cones, so that all pairs of levels can be tried.
VisibilityMap random_map(std::size_t cells, std::mt19937& random)
{
    VisibilityMap map{6, cells};
    std::bernoulli_distribution is_open{0.25};
    for (std::size_t cell = 0; cell < cells; ++cell)
        for (std::size_t facet = 0; facet < map.facets(); ++facet)
            if (is_open(random))
                map.column(cell)[0] |= std::uint64_t{1} << facet;
    return map;
}

/// The least objective over all pairs of levels of cells, each with its least window.
double all_levels(const ConeFitting& fitting, const Vec3& axis)
{
    const AxisView view =
        axis_view({fitting.measure.family, axis, 0, {4, 4}}, fitting.centres);
    const std::vector<SweptRange> all{{0, view.swept.size()}};
    WindowSweep sweep{*fitting.cones};
    std::array<std::vector<double>, 2> levels{{{0.0}, {0.0}}};
    for (const SeenCell& cell : view.swept)
        levels[cell.side].push_back(cell.level);
    double best = infinity;
    for (const double m0 : levels[0])
        for (const double m1 : levels[1])
            if (const auto window = sweep.least(view, all, {{m0, m1}}, 7))
                if (fitting.limits.hold(m0, m1) &&
                    window->width <= fitting.limits.widest())
                    best = std::min(best, fitting.measure({window->width, m0, m1}));
    return best;
}

TEST(AxisFitter, FindsTheBestOfAllLevels)
{
    const SphereGrid grid = sphere_grid("hex:1");
    std::mt19937 random{8};
    std::uniform_real_distribution<double> uniform{-1, 1};
    using enum SetupObjective;
    for (const SetupObjective objective : {FlooredArea, TotalRange, Tilt}) {
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            for (int trial = 0; trial < 40; ++trial) {
                const ConeSet cones{random_map(grid.centres.size(), random)};
                std::vector<Vec3> centres;
                for (const std::size_t cell : cones.cells())
                    centres.push_back(grid.centres[cell]);
                RotaryLimits limits;
                if (trial % 2 == 1)
                    limits = {{-0.6, 1.3}, {-0.8, 1.2}};
                const ConeFitting fitting{&cones,
                                          centres,
                                          {family, objective, 0.1},
                                          RangeLimits{family, limits}};
                const Vec3 axis =
                    Vec3{uniform(random), uniform(random), uniform(random)}.normalized();
                AxisFitter fitter{fitting};
                const auto fit = fitter.best(axis, {infinity});
                const double expected = all_levels(fitting, axis);
                ASSERT_EQ(fit.has_value(), expected < infinity);
                if (!fit)
                    continue;
                EXPECT_NEAR(fit->objective, expected, 1e-14 * expected);
                EXPECT_FALSE(fitter.best(axis, {fit->objective}));
            }
        }
    }
}

TEST(Descent, NeverRaisesTheObjective)
{
    const SphereGrid grid = sphere_grid("hex:3");
    std::mt19937 random{9};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const ConeSet cones{random_map(grid.centres.size(), random)};
        std::vector<Vec3> centres;
        for (const std::size_t cell : cones.cells())
            centres.push_back(grid.centres[cell]);
        const ConeFitting fitting{&cones, centres, {family}, RangeLimits{family, {}}};
        AxisFitter fitter{fitting};
        const auto fit = fitter.best(Vec3{1, 2, 3}.normalized(), {infinity});
        ASSERT_TRUE(fit);
        const AxisFit lower = descend(fitter, *fit, {0.1});
        EXPECT_LT(lower.objective, fit->objective);
        const auto again = fitter.best(lower.axis, {infinity});
        EXPECT_LE(again->objective, lower.objective);
    }
}

TEST(FittedPose, DividesTheWindowAsZeroDividesTheLimits)
{
    const AxisFit fit{Vec3::UnitX(), {0.3, 0.9}, {0.9, 0.2, 0.1}, 0};
    const RotaryLimits limits{{-1, 2}, {-0.5, 0.5}};
    const FittedPose ab = fitted_pose(fit, RotaryFamily::AB, limits);
    EXPECT_NEAR(ab.phi.from, -0.3, 1e-15);
    EXPECT_NEAR(ab.phi.to, 0.6, 1e-15);
    EXPECT_NEAR(ab.theta.from, -0.1, 1e-15);
    EXPECT_NEAR(ab.area, 0.27, 1e-15);
    EXPECT_NEAR(ab.pose.tool_axis.dot(ab.pose.r1_axis), 0, 1e-15);
    EXPECT_LT((ab.pose.r2_axis - ab.pose.tool_axis.cross(ab.pose.r1_axis)).norm(), 1e-15);

    const FittedPose ca = fitted_pose(fit, RotaryFamily::CA, {{-0.3, 0.15}, {-pi, pi}});
    EXPECT_EQ(ca.phi.to, 0.1);  // m0 fits the limits only with a negative sign
    EXPECT_EQ(ca.phi.from, -0.2);
    EXPECT_NEAR(ca.theta.to, 0.45, 1e-15);
    EXPECT_NEAR(ca.pose.tool_axis.dot(ca.pose.r2_axis), 0, 1e-15);
}

}  // namespace
}  // namespace endmill
