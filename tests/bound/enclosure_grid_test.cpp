// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/enclosure_grid.h"

#include <numeric>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/raised_point.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double spacing = 3;

struct Fixture {
    explicit Fixture(std::vector<Surface> surfaces)
        : sided{std::move(surfaces)},
          density(grid.nodes(), 0.2)
    {
    }

    test::SidedSurfaces sided;
    BoundedPart part = sided.part();
    BoundProblem problem = test::usual_problem();
    DensityGrid grid{part, spacing};
    std::vector<double> density;
    EnclosureGrid enclosures{part, problem, grid, density, 0.6, 3};
};

TEST(EnclosureGrid, HasTheRaisedSurfaceInItsLeaves)
{
    const Fixture saddle{{test::saddle(64, 30)}};
    const Interval u = saddle.part.surfaces[0].range(Parameter::U);
    const Interval v = saddle.part.surfaces[0].range(Parameter::V);
    for (const double share : {0.0, 0.31, 0.77}) {
        const SurfacePoint at{std::lerp(u.low, u.high, share),
                              std::lerp(v.low, v.high, 0.4)};
        const auto range = saddle.enclosures.range(0, {{at.u, at.u}, {at.v, at.v}});
        ASSERT_TRUE(range);
        const SurfaceLeaf& leaf = saddle.enclosures.leaf(0, range->high_u, range->high_v);
        EXPECT_TRUE(leaf.is_inside);
        const RaisedJet jet = raised_jet(saddle.part, 0, at, 0.5);
        for (int c = 0; c < 3; ++c)
            EXPECT_TRUE(leaf.point[c].low - 1e-9 <= jet.point[c] &&
                        jet.point[c] <= leaf.point[c].high + 1e-9);
        EXPECT_NEAR(0.2 * jet.area, (leaf.density.low + leaf.density.high) / 2,
                    0.02 * jet.area);
    }
    EXPECT_FALSE(saddle.enclosures.range(0, {{u.low - 10, u.low}, v}));
}

TEST(EnclosureGrid, TheNearLeavesAreThoseThatTheToolReaches)
{
    const Fixture plane{{test::plane(40, 40)}};
    const Vec3 contact =
        plane.part.surfaces[0].tangents(0.5, 0.5).point + Vec3{0, 0, 7.5};
    const EnclosureGrid::Near near =
        plane.enclosures.near(0, ToolReach{plane.problem, contact}, 0);
    ASSERT_TRUE(near.own);
    EXPECT_TRUE(near.cells_of_others.empty());
    // A disc of radius 2.69 in leaves of 0.6.
    EXPECT_GT(near.columns.size(), 3.14 * 2.69 * 2.69 / 0.36);
    EXPECT_LT(near.columns.size(), 3.14 * 3.6 * 3.6 / 0.36);
    EXPECT_FALSE(
        plane.enclosures.near(0, ToolReach{plane.problem, contact + Vec3{0, 0, 9}}, 0)
            .own);
}

TEST(EnclosureGrid, BoundsTheIntegralFromBelow)
{
    const Fixture saddle{{test::saddle(64, 30)}};
    const double integral = 0.2 * std::accumulate(saddle.grid.weights().begin(),
                                                  saddle.grid.weights().end(), 0.0);
    EXPECT_LE(saddle.enclosures.least_integral(saddle.density), integral * (1 + 1e-9));
    EXPECT_GE(saddle.enclosures.least_integral(saddle.density), 0.999 * integral);
}

// The saddle is one polynomial in nine patches; curvature jumps in the default net.
TEST(EnclosureGrid, KnowsWhereSecondDerivativesJump)
{
    const Fixture saddle{test::dataset("saddle").surfaces};
    EXPECT_FALSE(saddle.enclosures.has_jump(0, {{0, 3}, {0, 3}}));
    const Fixture net{test::dataset("net_rot24_7D").surfaces};
    EXPECT_TRUE(net.enclosures.has_jump(0, {{0.9, 1.1}, {0.1, 0.9}}));
    EXPECT_FALSE(net.enclosures.has_jump(0, {{0.1, 0.9}, {0.1, 0.9}}));
}

}  // namespace
}  // namespace endmill
