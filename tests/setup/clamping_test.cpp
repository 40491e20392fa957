// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/clamping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/setup/setup_travel.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"
#include "random_maps.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A random part: triangles without order, with random cones.
struct RandomPart {
    explicit RandomPart(unsigned seed)
    {
        test::Random random{seed};
        std::vector<Vec3> points;
        std::vector<Triangle> triangles;
        for (std::int32_t facet = 0; facet < 90; ++facet) {
            const Vec3 middle{random.uniform(-40, 60), random.uniform(-30, 30),
                              random.uniform(0, 50)};
            for (int k = 0; k < 3; ++k)
                points.push_back(middle + test::random_direction(random));
            triangles.push_back({3 * facet, 3 * facet + 1, 3 * facet + 2});
        }
        mesh = TriangleMesh{points, triangles};
        visibility.map = VisibilityMap{90, grid.centres.size()};
        for (std::size_t facet = 0; facet < 90;
             facet += 2) {  // two facets with each cone
            const Vec3 middle = test::random_direction(random);
            for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
                for (const std::size_t own : {facet, facet + 1})
                    if (middle.dot(grid.centres[cell]) > 0.8)
                        test::make_accessible(visibility.map, own, cell);
        }
        const Vec3 axis = test::random_direction(random);
        const Vec3 across = axis.unitOrthogonal();
        pose = {axis, axis, across};
    }

    SphereGrid grid = sphere_grid("hex:4");
    TriangleMesh mesh;
    PartVisibility visibility;
    SetupPose pose;
};

Machine machine_of(const char* word)
{
    Machine machine{.configuration = configuration_from_word(word),
                    .pivot = 120,
                    .table_offset = {10, -20, 30}};
    machine.rotary = widest_limits(machine.configuration);
    machine.linear = {LinearRange{-100, 150}, {-90, 80}, {-60, 200}};
    return machine;
}

// The slack at a clamping position by the positions of all facets.
Vec3 slack_by_travel(const RandomPart& part, const Machine& machine,
                     const RotaryLimits& limits, const Vec3& clamp)
{
    const auto reached =
        reached_points(part.mesh, part.visibility, part.grid.centres,
                       pose_frame(machine.configuration, part.pose), limits);
    const SetupTravel travel =
        setup_travel(machine, part_to_machine(part.pose, machine.configuration),
                     reached.value(), clamp, /*tool_length=*/40);
    Vec3 slack;
    for (int k = 0; k < 3; ++k)
        slack[k] = std::min(travel.low[k] - machine.linear[k].from,
                            machine.linear[k].to - travel.high[k]);
    return slack;
}

constexpr std::array words{"W/caxyBz/T", "W/cxyBza/T", "W/xyBzca/T"};

TEST(ClampingSearch, HasTheSlackOfThePositionsOfAllFacets)
{
    test::Random random{11};
    for (const char* word : words) {
        const RandomPart part{3};
        const Machine machine = machine_of(word);
        const RotaryLimits limits = reach_limits({machine.configuration, machine.rotary});
        const ClampingSearch search{part.mesh, part.visibility, part.grid.centres,
                                    machine,   limits,          40};
        const auto bounds = search.bounds(part.pose);
        ASSERT_TRUE(bounds);
        for (int i = 0; i < 20; ++i) {
            const Vec3 clamp = 100 * test::random_direction(random);
            EXPECT_LT((clamping_fit(*bounds, clamp).slack -
                       slack_by_travel(part, machine, limits, clamp))
                          .norm(),
                      1e-9)
                << word;
        }
    }
}

// The least slack is a concave function of the clamping position. A search by steps that
// become shorter therefore finds its maximum from any start.
TEST(BestClamping, IsNotImprovedByBruteForce)
{
    test::Random random{12};
    for (const char* word : words)
        for (const unsigned seed : {1U, 2U, 4U}) {
            const RandomPart part{seed};
            const Machine machine = machine_of(word);
            const RotaryLimits limits =
                reach_limits({machine.configuration, machine.rotary});
            const auto bounds =
                ClampingSearch{part.mesh, part.visibility, part.grid.centres,
                               machine,   limits,          40}
                    .bounds(part.pose);
            ASSERT_TRUE(bounds);
            const ClampingFit best = best_clamping(*bounds, Vec3::Zero());
            EXPECT_NEAR(best.least_slack(), greatest_slack(*bounds), 1e-6);
            EXPECT_LT(
                (slack_by_travel(part, machine, limits, best.clamp) - best.slack).norm(),
                1e-9);
            Vec3 clamp{0, 0, 0};
            double found = clamping_fit(*bounds, clamp).least_slack();
            for (double step = 200; step > 1e-4;) {
                bool is_better = false;
                for (int i = 0; i < 300; ++i) {
                    const Vec3 trial = clamp + step * test::random_direction(random);
                    const double slack = clamping_fit(*bounds, trial).least_slack();
                    if (slack > found) {
                        found = slack;
                        clamp = trial;
                        is_better = true;
                    }
                }
                if (!is_better)
                    step /= 2;
            }
            EXPECT_LE(found, best.least_slack() + 1e-6) << word << seed;
            EXPECT_GE(found, best.least_slack() - 2) << word << seed;
        }
}

// Without a rotation the axes do not depend on each other: each has half of what its
// travel is wider than the part.
TEST(BestClamping, CentresEachAxisWithoutRotations)
{
    const std::vector<ClampingBound> bounds{
        {0, Vec3::UnitX(), -10, 90}, {1, Vec3::UnitY(), 3, 5}, {2, Vec3::UnitZ(), 7, 1}};
    const ClampingFit best = best_clamping(bounds, Vec3::Zero());
    EXPECT_LT((best.slack - Vec3{50, 1, -3}).norm(), 1e-6);
    EXPECT_LT((best.clamp - Vec3{40, 4, 4}).norm(), 1e-6);
    EXPECT_FALSE(best.is_within());
}

// A point that a table turns once round stays within x if it is near the axis. At the
// angle a the bound on the clamping position (x, y) is |x cos a - y sin a| <= 10.
TEST(BestClamping, PutsAPointOnTheAxisOfATable)
{
    std::vector<ClampingBound> bounds;
    for (int degrees = 0; degrees < 360; degrees += 30) {
        const double a = Angle::degrees(degrees).radians();
        bounds.push_back({0,
                          {std::cos(a), -std::sin(a), 0},
                          -10 + 5 * std::cos(a),
                          10 + 5 * std::cos(a)});
    }
    const ClampingFit best = best_clamping(bounds, {0, 0, 77});
    EXPECT_LT((best.clamp - Vec3{5, 0, 77}).norm(), 1e-5);  // nothing bounds z
    EXPECT_NEAR(best.slack.x(), 10, 1e-6);
    EXPECT_EQ(best.slack.y(), infinity);
}

TEST(BestClamping, KeepsTheWantedPositionWithoutBounds)
{
    const Vec3 wanted{1, -2, 3};
    const ClampingFit best = best_clamping({}, wanted);
    EXPECT_LT((best.clamp - wanted).norm(), 1e-9);
    EXPECT_TRUE(best.is_within());
    EXPECT_EQ(greatest_slack({}), infinity);
}

TEST(BestClamping, AllowsATravelThatIsOpenToOneSide)
{
    const std::vector<ClampingBound> bounds{{0, Vec3::UnitX(), 4, infinity},
                                            {1, Vec3::UnitY(), -1, 1}};
    const ClampingFit best = best_clamping(bounds, Vec3::Zero());
    EXPECT_NEAR(best.slack.y(), 1, 1e-6);
    EXPECT_GE(best.slack.x(), 1 - 1e-6);
}

// The bounds of positions at the clamping position 0 give the slack at any other one, as its
// own positions do.
TEST(ClampingBounds, HaveTheSlackOfThePositionsAtEveryClamp)
{
    for (const char* word : {"W/caxyBz/T", "W/cxyBza/T", "W/xyBzba/T"}) {
        const Machine machine = machine_of(word);
        test::Random random{5};
        std::vector<std::pair<RotaryPositions, Vec3>> poses;
        for (int k = 0; k < 40; ++k) {
            const double turn = random.uniform(-3, 3);
            for (int same = 0; same < 2; ++same)  // two places with the same turns
                poses.emplace_back(RotaryPositions{turn, turn / 2},
                                   30 * test::random_direction(random));
        }
        std::vector<AxisPositions> positions;
        for (const auto& [rotary, point] : poses)
            positions.push_back(axis_positions(machine, rotary, point, 40));
        const std::vector<ClampingBound> bounds = clamping_bounds(machine, positions);
        EXPECT_EQ(bounds.size(), 3U * 40);
        const Vec3 clamp{12, -7, 31};
        Vec3 slack = Vec3::Constant(infinity);
        for (const auto& [rotary, point] : poses) {
            const Vec3 xyz = axis_positions(machine, rotary, point + clamp, 40).xyz;
            for (int k = 0; k < 3; ++k) {
                const LinearRange& range = machine.linear[static_cast<std::size_t>(k)];
                slack[k] = std::min({slack[k], xyz[k] - range.from, range.to - xyz[k]});
            }
        }
        EXPECT_NEAR((clamping_fit(bounds, clamp).slack - slack).norm(), 0, 1e-9) << word;
    }
}

}  // namespace
}  // namespace endmill
