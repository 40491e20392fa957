// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

// Cones that are caps of about 20 degrees around random directions of the upper half
// sphere.
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

// Number of random parts that are searched over whole cones. The environment variable
// ENDMILL_SET_SEARCHES sets more, up to 1000.
const int whole_cone_searches = [] {
    const char* const number = std::getenv("ENDMILL_SET_SEARCHES");
    return number == nullptr ? 10 : std::atoi(number);
}();

SetupRequest request_of(RotaryFamily family, SetupMode mode)
{
    return {.reach = {.configuration = configuration_of_family(family)}, .mode = mode};
}

// Random parts of at most 20 facets. Only the first parts use the search over whole
// cones, which takes longer.
TEST(FiveAxisSetup, LaterModesNeedNoMoreAndTheBoundIsNoLarger)
{
    const SphereGrid grid = sphere_grid("hex:4");
    test::Random random{5};
    for (int part = 0; part < 1000; ++part) {
        const auto facets = static_cast<std::size_t>(random.uniform(1, 20.99));
        const VisibilityMap map = random_cones(grid, random, facets);
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            const PartSetup paper =
                five_axis_setup(grid, map, request_of(family, SetupMode::Paper));
            const PartSetup corrected =
                five_axis_setup(grid, map, request_of(family, SetupMode::Corrected));
            ASSERT_TRUE(corrected.feasible);
            if (paper.feasible) {
                EXPECT_LE(corrected.feasible->area, paper.feasible->area * (1 + 1e-7));
            }
            if (part >= whole_cone_searches)
                continue;
            const PartSetup set =
                five_axis_setup(grid, map, request_of(family, SetupMode::WholeCones));
            ASSERT_TRUE(set.feasible);
            const PoseMeasure measure{.family = family};
            EXPECT_LE(*set.objective,
                      measure(pose_ranges(family, *corrected.feasible)) * (1 + 1e-12));
            EXPECT_NEAR(*set.objective, measure(pose_ranges(family, *set.feasible)),
                        1e-9);
            ASSERT_TRUE(set.certificate);
            EXPECT_LE(set.certificate->lower_bound, *set.objective);
            EXPECT_FALSE(corrected.certificate);
            EXPECT_TRUE(set.is_proved);
        }
    }
}

// A machine with A and B exchanged is the same machine seen from its side.
TEST(FiveAxisSetup, WordsThatBeginWithBHaveR2ReversedInAllModes)
{
    const SphereGrid grid = sphere_grid("hex:4");
    test::Random random{6};
    const VisibilityMap map = random_cones(grid, random, 10);
    for (const SetupMode mode : {SetupMode::Corrected, SetupMode::WholeCones}) {
        SetupRequest a_first = request_of(RotaryFamily::AB, mode);
        a_first.reach.limits = {{-1.4, 1.5}, {-0.9, 1.2}};
        SetupRequest b_first = a_first;
        b_first.reach.configuration = configuration_from_word("W/baBxyz/T");
        b_first.reach.limits.theta = {-1.2, 0.9};
        const PartSetup one = five_axis_setup(grid, map, a_first);
        const PartSetup other = five_axis_setup(grid, map, b_first);
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

TEST(FiveAxisSetup, ProvesThatNothingReachesOppositeFacets)
{
    const SphereGrid grid = sphere_grid("hex:4");
    VisibilityMap map{2, grid.centres.size()};
    for (std::size_t i = 0; i < grid.centres.size(); ++i) {
        if (grid.centres[i].z() > 0.9)
            map.column(i)[0] |= 1;
        if (grid.centres[i].z() < -0.9)
            map.column(i)[0] |= 2;
    }
    SetupRequest request = request_of(RotaryFamily::CA, SetupMode::WholeCones);
    request.reach.limits.phi = {-0.5, 0.5};
    const PartSetup none = five_axis_setup(grid, map, request);
    EXPECT_EQ(none.machinable, Answer::No);
    EXPECT_TRUE(none.is_proved);
    EXPECT_FALSE(none.feasible);
    EXPECT_TRUE(none.least);
    request.mode = SetupMode::Corrected;
    const PartSetup at_cells = five_axis_setup(grid, map, request);
    EXPECT_EQ(at_cells.machinable, Answer::No);
    EXPECT_FALSE(at_cells.is_proved);
}

TEST(FiveAxisSetup, WithoutConesHasTheAxesOfAMachine)
{
    const SphereGrid grid = sphere_grid("hex:2");
    const VisibilityMap none{3, grid.centres.size()};
    for (const char* word : {"W/caBxyz/T", "W/abBxyz/T", "W/baBxyz/T"}) {
        const MachineConfiguration configuration = configuration_from_word(word);
        const PartSetup found = five_axis_setup(
            grid, none,
            {.reach = {.configuration = configuration}, .mode = SetupMode::WholeCones});
        ASSERT_TRUE(found.feasible);
        const SetupPose& pose = found.feasible->pose;
        const bool is_ca = configuration.family == RotaryFamily::CA;
        EXPECT_EQ(pose.r1_axis.dot(pose.tool_axis), is_ca ? 1 : 0);
        // R1 and R2 are X and Y of the machine, Y and X if B is first, C and X in C,A.
        const Vec3 r2 = pose.tool_axis.cross(pose.r1_axis);
        EXPECT_EQ(pose.r2_axis.dot(pose.tool_axis), 0);
        EXPECT_EQ(r2.dot(pose.r2_axis),
                  is_ca                                                ? 0
                  : rotary_order(configuration) == RotaryOrder::BFirst ? -1
                                                                       : 1);
    }
}

TEST(FiveAxisSetup, NeedsTwoRotaryAxesThatTiltTheTool)
{
    const SphereGrid grid = sphere_grid("hex:2");
    const VisibilityMap none{1, grid.centres.size()};
    for (const char* word : {"W/xyBz/T", "W/axyBz/T", "W/acxyBz/T"})
        EXPECT_THROW(
            five_axis_setup(grid, none,
                            {.reach = {.configuration = configuration_from_word(word)}}),
            DomainError);
}

}  // namespace
}  // namespace endmill
