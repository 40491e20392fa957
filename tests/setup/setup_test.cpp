// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// Two facets are accessible within 30 degrees of two directions that are 90 degrees
// apart, and a third facet has no area.
struct TwoCones {
    SphereGrid grid = sphere_grid("hex:6");
    PartVisibility visibility{VisibilityMap{3, grid.centres.size()}, {2}};

    explicit TwoCones(std::initializer_list<Vec3> axes = {Vec3::UnitX(), Vec3::UnitY()})
    {
        std::size_t facet = 0;
        for (const Vec3& axis : axes) {
            for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
                if (grid.centres[cell].dot(axis) > std::sqrt(0.75))
                    visibility.map.column(cell)[0] |= std::uint64_t{1} << facet;
            ++facet;
        }
    }
};

SetupRequest request_for(const char* word)
{
    const MachineConfiguration configuration = configuration_from_word(word);
    return {.reach = {.configuration = configuration,
                      .limits = widest_limits(configuration)}};
}

TEST(FindSetup, UsesTheSearchThatSuitsTheMachine)
{
    const TwoCones part;
    const PartSetup three =
        find_setup(part.grid, part.visibility, request_for("W/xyBz/T"));
    EXPECT_EQ(three.machinable, Answer::No);
    EXPECT_TRUE(three.is_proved);
    EXPECT_FALSE(three.shown());
    EXPECT_EQ(three.poses_tried, part.grid.centres.size());

    const PartSetup four =
        find_setup(part.grid, part.visibility, request_for("W/aBxyz/T"));
    EXPECT_EQ(four.machinable, Answer::Yes);
    EXPECT_EQ(four.status, SetupStatus::FourAxis);
    EXPECT_EQ(four.poses_tried, 5120U);

    const PartSetup five =
        find_setup(part.grid, part.visibility, request_for("W/caBxyz/T"));
    EXPECT_EQ(five.machinable, Answer::Yes);
    EXPECT_EQ(five.feasible->area,
              five_axis_setup(part.grid, part.visibility.map, request_for("W/caBxyz/T"))
                  .feasible->area);
}

// The cones are caps of 30 degrees about axes 90 degrees apart, so that 30 degrees lie
// between them. The arc tolerance of 2.95 degrees shortens the arc at either end; the
// outermost centres of the cells, which are 10 degrees wide, lengthen it.
TEST(FindSetup, NeedsTheAngleBetweenTwoCapsWithFourAxes)
{
    const TwoCones part;
    const PartSetup found =
        find_setup(part.grid, part.visibility, request_for("W/bBxyz/T"));
    ASSERT_TRUE(found.feasible);
    const RotaryRange& phi = found.feasible->phi;
    EXPECT_GT(Angle::radians(phi.to - phi.from).degrees(), 30 - 2 * 2.95);
    EXPECT_LT(Angle::radians(phi.to - phi.from).degrees(), 30 + 2 * 10);
    EXPECT_EQ(found.feasible->theta, (RotaryRange{0, 0}));
    EXPECT_EQ(*found.objective, 0);  // the area of an arc
}

TEST(FindSetup, FindsOneDirectionForThreeAxes)
{
    const TwoCones part{Vec3::UnitX(), Vec3{1, 0.5, 0}.normalized()};
    const PartSetup found =
        find_setup(part.grid, part.visibility, request_for("W/xyBz/T"));
    EXPECT_EQ(found.machinable, Answer::Yes);
    EXPECT_EQ(found.status, SetupStatus::ThreeAxis);
    ASSERT_TRUE(found.feasible);
    for (const Vec3& axis : {Vec3{Vec3::UnitX()}, Vec3{1, 0.5, 0}.normalized()})
        EXPECT_GT(found.feasible->pose.tool_axis.dot(axis), std::sqrt(0.75));
    EXPECT_NEAR(found.feasible->pose.tool_axis.dot(found.feasible->pose.r1_axis), 0,
                1e-15);
}

TEST(FindSetup, ProvesThatNoMachineReachesAnEmptyCone)
{
    TwoCones part;
    part.visibility.dropped.clear();  // the third facet has an area now
    for (const char* word : {"W/xyBz/T", "W/aBxyz/T", "W/caBxyz/T", "W/abBxyz/T"})
        for (const SetupMode mode : {SetupMode::Paper, SetupMode::WholeCones}) {
            SetupRequest request = request_for(word);
            request.mode = mode;
            const PartSetup found = find_setup(part.grid, part.visibility, request);
            EXPECT_EQ(found.machinable, Answer::No) << word;
            EXPECT_TRUE(found.is_proved) << word;
            EXPECT_FALSE(found.feasible) << word;
            EXPECT_FALSE(found.certificate) << word;
            // Two facets are left, which three axes do not reach.
            EXPECT_EQ(found.least.has_value(), std::string{word} != "W/xyBz/T") << word;
            EXPECT_EQ(found.objective.has_value(), found.least.has_value()) << word;
        }
}

TEST(FindSetup, FindsNothingOnAnInvalidMachine)
{
    const TwoCones part;
    for (const char* word : {"W/cBxyz/T", "W/acBxyz/T"}) {
        const PartSetup found = find_setup(part.grid, part.visibility, request_for(word));
        EXPECT_EQ(found.machinable, Answer::No);
        EXPECT_TRUE(found.is_proved);
        EXPECT_FALSE(found.shown());
        EXPECT_EQ(found.poses_tried, 0U);
    }
}

FittedPose fit_of(const RotaryRange& phi, const RotaryRange& theta)
{
    FittedPose fit{};
    fit.phi = phi;
    fit.theta = theta;
    return fit;
}

TEST(FlooredArea, IsTheProductOfBothRangesInDegreesAndTheFloor)
{
    const double one_degree = std::numbers::pi / 180;
    PartSetup setup;
    setup.least = fit_of({-10 * one_degree, 20 * one_degree}, {0, 40 * one_degree});
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
        EXPECT_NEAR(*floored_area_deg2(setup, configuration_of_family(family), 5),
                    35 * 45, 1e-10);
    // With one rotary axis only phi moves.
    setup.least = fit_of({-10 * one_degree, 20 * one_degree}, {0, 0});
    EXPECT_NEAR(*floored_area_deg2(setup, configuration_from_word("W/aBxyz/T"), 5),
                35 * 5, 1e-10);
    EXPECT_FALSE(floored_area_deg2(PartSetup{}, configuration_from_word("W/aBxyz/T"), 5));
}

TEST(SetupRank, OrdersByMachinabilityThenAreaThenWord)
{
    const auto rank = [](Answer machinable, double range, const char* word) {
        PartSetup setup;
        setup.machinable = machinable;
        if (range > 0)
            setup.least = fit_of({0, range}, {0, range});
        return setup_rank(setup, configuration_from_word(word), 5.9);
    };
    using enum Answer;
    const std::vector<SetupRank> ranked{
        rank(Yes, 0.5, "W/abBxyz/T"), rank(Yes, 0.5, "W/caBxyz/T"),
        rank(Yes, 1, "W/abBxyz/T"),   rank(Undecided, 0.1, "W/abBxyz/T"),
        rank(No, 1, "W/caBxyz/T"),    rank(No, 0, "W/abBxyz/T"),
        rank(No, 0, "W/acBxyz/T")};
    for (std::size_t k = 1; k < ranked.size(); ++k)
        EXPECT_LT(ranked[k - 1], ranked[k]) << k;
}

}  // namespace
}  // namespace endmill
