// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/best_setup.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "endmill/setup/pose_search.h"
#include "random.h"

namespace endmill {
namespace {

// Cones that are caps of some 20 degrees about random directions of the upper half.
VisibilityMap random_cones(const SphereGrid& grid, test::Random& random,
                           std::size_t facets)
{
    VisibilityMap map{facets, grid.centres.size()};
    for (std::size_t j = 0; j < facets; ++j) {
        const Vec3 axis =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)}
                .normalized();
        const double reach = random.uniform(0.85, 0.95);
        for (std::size_t i = 0; i < grid.centres.size(); ++i)
            if (grid.centres[i].dot(axis) > reach)
                map.column(i)[j / 64] |= std::uint64_t{1} << (j % 64);
    }
    return map;
}

// Of the random parts; ENDMILL_SET_SEARCHES says how many more, up to 1000.
const int set_searches = [] {
    const char* const told = std::getenv("ENDMILL_SET_SEARCHES");
    return told == nullptr ? 10 : std::atoi(told);
}();

SetupRequest request_of(RotaryFamily family, std::optional<SetupMode> mode)
{
    return {.family = family, .mode = mode};
}

// Random parts of at most 20 facets, the first few by all modes, the rest by those at cells:
// the search over whole cones takes longer.
TEST(BestSetup, LaterModesNeedNoMoreAndTheBoundIsNoLarger)
{
    const SphereGrid grid = sphere_grid("hex:4");
    test::Random random{5};
    for (int part = 0; part < 1000; ++part) {
        const auto facets = static_cast<std::size_t>(random.uniform(1, 20.99));
        const VisibilityMap map = random_cones(grid, random, facets);
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            const BestSetup paper =
                best_setup(grid, map, request_of(family, SetupMode::Paper));
            const BestSetup corrected =
                best_setup(grid, map, request_of(family, SetupMode::Corrected));
            ASSERT_TRUE(corrected.feasible);
            if (paper.feasible) {
                EXPECT_LE(corrected.feasible->area, paper.feasible->area * (1 + 1e-7));
            }
            if (part >= set_searches)
                continue;
            const BestSetup set = best_setup(grid, map, request_of(family, std::nullopt));
            ASSERT_TRUE(set.feasible);
            const PoseMeasure measure{.family = family};
            EXPECT_LE(*set.objective,
                      measure(pose_ranges(family, *corrected.feasible)) * (1 + 1e-12));
            EXPECT_NEAR(*set.objective, measure(pose_ranges(family, *set.feasible)),
                        1e-9);
            EXPECT_LE(*set.lower_bound, *set.objective);
            EXPECT_TRUE(set.is_proved);
        }
    }
}

// The machine with A and B exchanged is the same machine seen from its side.
TEST(BestSetup, WordsThatBeginWithBHaveR2ReversedInAllModes)
{
    const SphereGrid grid = sphere_grid("hex:4");
    test::Random random{6};
    const VisibilityMap map = random_cones(grid, random, 10);
    for (const std::optional<SetupMode> mode :
         {std::optional{SetupMode::Corrected}, std::optional<SetupMode>{}}) {
        SetupRequest a_first = request_of(RotaryFamily::AB, mode);
        a_first.limits = {{-1.4, 1.5}, {-0.9, 1.2}};
        SetupRequest b_first = a_first;
        b_first.is_b_first = true;
        b_first.limits.theta = {-1.2, 0.9};
        const BestSetup one = best_setup(grid, map, a_first);
        const BestSetup other = best_setup(grid, map, b_first);
        ASSERT_EQ(one.feasible.has_value(), other.feasible.has_value());
        ASSERT_TRUE(one.feasible);
        EXPECT_LT((one.feasible->pose.r1_axis - other.feasible->pose.r1_axis).norm(),
                  1e-9);
        EXPECT_LT((one.feasible->pose.r2_axis + other.feasible->pose.r2_axis).norm(),
                  1e-9);
        EXPECT_NEAR(one.feasible->theta.to, -other.feasible->theta.from, 1e-9);
        EXPECT_NEAR(one.feasible->phi.to, other.feasible->phi.to, 1e-9);
    }
}

TEST(BestSetup, ProvesThatNothingReachesOppositeFacets)
{
    const SphereGrid grid = sphere_grid("hex:4");
    VisibilityMap map{2, grid.centres.size()};
    for (std::size_t i = 0; i < grid.centres.size(); ++i) {
        if (grid.centres[i].z() > 0.9)
            map.column(i)[0] |= 1;
        if (grid.centres[i].z() < -0.9)
            map.column(i)[0] |= 2;
    }
    SetupRequest request = request_of(RotaryFamily::CA, std::nullopt);
    request.limits.phi = {-0.5, 0.5};
    const BestSetup none = best_setup(grid, map, request);
    EXPECT_EQ(none.is_machinable, std::optional{false});
    EXPECT_TRUE(none.is_proved);
    EXPECT_FALSE(none.feasible);
    EXPECT_TRUE(none.least);
    request.mode = SetupMode::Corrected;
    const BestSetup at_cells = best_setup(grid, map, request);
    EXPECT_EQ(at_cells.is_machinable, std::optional{false});
    EXPECT_FALSE(at_cells.is_proved);
}

TEST(BestSetup, WithNothingToReachAxesStandAsThoseOfAMachine)
{
    const SphereGrid grid = sphere_grid("hex:2");
    const VisibilityMap none{3, grid.centres.size()};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
        for (const bool is_b_first : {false, true}) {
            SetupRequest request = request_of(family, std::nullopt);
            request.is_b_first = is_b_first && family == RotaryFamily::AB;
            const BestSetup found = best_setup(grid, none, request);
            ASSERT_TRUE(found.feasible);
            const SetupPose& pose = found.feasible->pose;
            const bool is_ca = family == RotaryFamily::CA;
            EXPECT_EQ(pose.r1_axis.dot(pose.tool_axis), is_ca ? 1 : 0);
            // R1, R2 are X, Y of the machine, or Y, X where B is first; in C,A the tool axis, X.
            const Vec3 r2 = pose.tool_axis.cross(pose.r1_axis);
            EXPECT_EQ(pose.r2_axis.dot(pose.tool_axis), 0);
            EXPECT_EQ(r2.dot(pose.r2_axis), is_ca ? 0 : request.is_b_first ? -1 : 1);
        }
}

TEST(BestSetup, MagnitudesAndRangesAreThoseOfThePaper)
{
    FittedPose fit{.pose = {}, .phi = {-0.2, 0.5}, .theta = {-0.4, 0.1}, .area = 0};
    EXPECT_EQ(magnitudes(fit.phi), (std::array{0.2, 0.5}));
    EXPECT_EQ(magnitudes(fit.theta), (std::array{0.1, 0.4}));
    const PoseRanges ca = pose_ranges(RotaryFamily::CA, fit);
    EXPECT_EQ(ca.width, 0.5);
    EXPECT_EQ(ca.height(), 0.7);
    EXPECT_EQ(pose_ranges(RotaryFamily::AB, fit).width, 0.7);
}

}  // namespace
}  // namespace endmill
