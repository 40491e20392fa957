// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup.h"

#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/machine/axis_limits.h"

namespace endmill {
namespace {

// Two facets of a part, accessible from within 25 degrees of z. The centroids are a
// distance of |(3, 1, 2)| apart.
struct TwoFacets {
    TriangleMesh mesh{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {3, 1, 2}, {6, 1, 2}, {3, 4, 2}},
                      {{0, 1, 2}, {3, 4, 5}}};
    SphereGrid grid = sphere_grid("hex:4");
    PartVisibility visibility{VisibilityMap{2, grid.centres.size()}, {}};

    TwoFacets()
    {
        for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
            if (grid.centres[cell].z() > std::cos(Angle::degrees(25).radians()))
                visibility.map.column(cell)[0] = 0b11;
    }
    PartWithCones part() const { return {mesh, grid, visibility}; }
};

Machine machine_of(const char* word)
{
    const MachineConfiguration configuration = configuration_from_word(word);
    return {.configuration = configuration, .rotary = widest_limits(configuration)};
}

// Three linear axes only turn the part once, so that they travel as far as the two
// centroids are apart, and a shifted clamp shifts the travel.
TEST(MachineSetup, TravelsTheDistanceOfTheFacetsWithThreeAxes)
{
    const TwoFacets example;
    const Machine machine = machine_of("W/xyBz/T");
    const MachineSetup setup = machine_setup(example.part(), machine, {}, Clamping{});
    ASSERT_TRUE(setup.travel);
    EXPECT_NEAR((setup.travel->high - setup.travel->low).norm(), std::sqrt(14), 1e-12);
    const Vec3 shift{5, -7, 11};
    const MachineSetup shifted =
        machine_setup(example.part(), machine, {}, Clamping{.origin = shift});
    EXPECT_LT((shifted.travel->low - setup.travel->low - shift).norm(), 1e-12);
    EXPECT_LT((shifted.travel->high - setup.travel->high - shift).norm(), 1e-12);
}

TEST(MachineSetup, IsMachinableWhereTheLimitsContainTheTravel)
{
    const TwoFacets example;
    for (const char* word : {"W/xyBz/T", "W/axyBz/T", "W/caxyBz/T"}) {
        Machine machine = machine_of(word);
        const MachineSetup free = machine_setup(example.part(), machine, {}, Clamping{});
        EXPECT_FALSE(free.has_linear_limits());
        EXPECT_EQ(free.within_travel, Answer::Yes);
        ASSERT_TRUE(free.travel);
        const double low = free.travel->low.x();
        const double high = free.travel->high.x();
        machine.linear[0] = {low, high};
        const MachineSetup fits = machine_setup(example.part(), machine, {}, Clamping{});
        EXPECT_TRUE(fits.has_linear_limits());
        EXPECT_EQ(fits.within_travel, Answer::Yes) << word;
        EXPECT_TRUE(fits.is_machinable()) << word;
        machine.linear[0] = {low, high - 1e-3};
        const MachineSetup beyond =
            machine_setup(example.part(), machine, {}, Clamping{});
        EXPECT_EQ(beyond.best.machinable, Answer::Yes) << word;
        EXPECT_EQ(beyond.within_travel, Answer::No) << word;
        EXPECT_FALSE(beyond.is_machinable()) << word;
    }
}

TEST(MachineSetup, HasNoTravelWithoutAClampingOrAFeasiblePose)
{
    TwoFacets example;
    Machine machine = machine_of("W/caxyBz/T");
    machine.linear[0] = {-1, 1};
    const MachineSetup family =
        machine_setup(example.part(), machine, {}, /*clamping=*/std::nullopt);
    EXPECT_TRUE(family.part_to_machine);
    EXPECT_FALSE(family.travel);
    EXPECT_EQ(family.within_travel, Answer::Undecided);
    EXPECT_TRUE(family.is_machinable());

    example.visibility.map = VisibilityMap{2, example.grid.centres.size()};
    const MachineSetup none = machine_setup(example.part(), machine, {}, Clamping{});
    EXPECT_FALSE(none.travel);
    EXPECT_EQ(none.within_travel, Answer::Undecided);
    EXPECT_FALSE(none.is_machinable());
}

TEST(MachineSetup, UsesTheRotaryLimitsOfTheMachine)
{
    const TwoFacets example;
    Machine machine = machine_of("W/caxyBz/T");
    machine.rotary.phi = {-0.1, 0.2};
    const SetupRequest other{
        .reach = {.configuration = configuration_from_word("W/xyBz/T")}};
    const MachineSetup found = machine_setup(example.part(), machine, other, Clamping{});
    EXPECT_NE(found.best.status, SetupStatus::NoOpenHemisphere);
    const PartSetup expected = find_setup(
        example.grid, example.visibility,
        {.reach = {.configuration = machine.configuration, .limits = machine.rotary}});
    ASSERT_TRUE(found.best.feasible && expected.feasible);
    EXPECT_EQ(found.best.poses_tried, expected.poses_tried);
    EXPECT_EQ(found.best.feasible->area, expected.feasible->area);
}

// Every combination of the answers: only a proved lack of travel on an axis with limits
// makes a machinable part not machinable.
TEST(MachineSetup, IsMachinableUnlessTheTravelIsProvedTooShort)
{
    using enum Answer;
    for (const Answer machinable : {Yes, No, Undecided})
        for (const Answer within : {Yes, No, Undecided})
            for (const bool is_limited : {false, true}) {
                MachineSetup setup;
                setup.best.machinable = machinable;
                setup.within_travel = within;
                if (is_limited)
                    setup.machine.linear[2] = {-1, 1};
                EXPECT_EQ(setup.is_machinable(),
                          machinable == Yes && (within != No || !is_limited));
            }
}

TEST(MachineSetup, RanksAsTheSetupForItsRotaryAxes)
{
    const TwoFacets example;
    std::vector<SetupRank> ranks;
    for (const char* word : {"W/caxyBz/T", "W/xyBz/T", "W/acxyBz/T"}) {
        const MachineSetup setup =
            machine_setup(example.part(), machine_of(word), {}, Clamping{});
        ranks.push_back(setup_rank(setup, 5));
        EXPECT_EQ(ranks.back(), setup_rank(setup.best, setup.machine.configuration, 5));
        EXPECT_EQ(floored_area_deg2(setup, 5).has_value(),
                  setup.best.shown().has_value());
    }
    EXPECT_EQ(ranks[1].area_deg2, 25);  // no rotary axis turns: the floor squared
    EXPECT_LT(ranks[0], ranks[2]);      // C over A turns the tool about itself
    EXPECT_LT(ranks[1], ranks[2]);
}

}  // namespace
}  // namespace endmill
