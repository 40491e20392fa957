// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/sampled_poses.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "endmill/setup/setup.h"
#include "endmill/setup/setup_travel.h"
#include "plane_part.h"
#include "random.h"
#include "random_maps.h"

namespace endmill {
namespace {

// Facets with cones about random directions within 50 degrees of z.
struct LeaningPart {
    SphereGrid grid = sphere_grid("hex:4");
    PartVisibility visibility{VisibilityMap{6, grid.centres.size()}, {}};

    LeaningPart()
    {
        test::Random random{3};
        for (std::size_t facet = 0; facet < 6; ++facet) {
            const double azimuth = random.uniform(0, 6);
            const double polar = random.uniform(0.5, 0.9);
            const Vec3 middle{std::sin(polar) * std::cos(azimuth),
                              std::sin(polar) * std::sin(azimuth), std::cos(polar)};
            for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
                if (middle.dot(grid.centres[cell]) > 0.95)
                    test::make_accessible(visibility.map, facet, cell);
        }
    }
};

// Every pose reaches every facet within the ranges that it states, up to rounding, and
// these lie within the limits of the machine.
TEST(SampledPoses, ReachEveryFacetWithinTheirRanges)
{
    const LeaningPart part;
    for (const char* word : {"W/caxyBz/T", "W/xyBzca/T", "W/abxyBz/T", "W/xyBzba/T"}) {
        const Machine machine = test::machine_of(word);
        const auto poses =
            sampled_poses(part.grid, part.visibility,
                          {{machine.configuration, {{-1.2, 1.5}, {-1.5, 1.4}}}});
        ASSERT_GT(poses.size(), 20U) << word;
        double before = 0;
        for (const FittedPose& fit : poses) {
            EXPECT_GE(fit.phi.from, -1.2 - 1e-9);
            EXPECT_LE(fit.theta.to, 1.4 + 1e-9);
            EXPECT_GE(fit.area, before * (1 - 1e-8));
            before = fit.area;
            const RotaryLimits ranges{{fit.phi.from - 1e-6, fit.phi.to + 1e-6},
                                      {fit.theta.from - 1e-6, fit.theta.to + 1e-6}};
            for (const auto& reach :
                 facet_reach(part.visibility.map, part.grid.centres,
                             pose_frame(machine.configuration, fit.pose), ranges))
                EXPECT_TRUE(reach) << word;
        }
    }
}

TEST(SampledPoses, BeginWithTheBestPoseOfTheSearch)
{
    const LeaningPart part;
    for (const char* word : {"W/caxyBz/T", "W/abxyBz/T"}) {
        const Machine machine = test::machine_of(word);
        SetupRequest request;
        request.reach = {machine.configuration, machine.rotary};
        const PartSetup best = find_setup(part.grid, part.visibility, request);
        const auto poses =
            sampled_poses(part.grid, part.visibility, {request.reach, request.mode});
        ASSERT_FALSE(poses.empty()) << word;
        EXPECT_NEAR(poses.front().area, best.feasible->area, 1e-9) << word;
    }
}

TEST(SampledPoses, OfThreeAxesTurnThePartAboutEachCell)
{
    const test::PlanePart plane;
    const Machine machine = test::machine_of("W/xyBz/T");
    const auto poses = sampled_poses(plane.grid, plane.visibility,
                                     {{machine.configuration, machine.rotary}});
    std::size_t cells = 0;
    for (std::size_t cell = 0; cell < plane.grid.centres.size(); ++cell)
        cells += plane.visibility.map.is_accessible(0, cell) ? 1 : 0;
    EXPECT_EQ(poses.size(), 36 * cells);
    std::set<std::pair<double, double>> different;
    for (const FittedPose& fit : poses)
        different.emplace(fit.pose.r1_axis.x(), fit.pose.r1_axis.y());
    EXPECT_EQ(different.size(), poses.size());
}

}  // namespace
}  // namespace endmill
