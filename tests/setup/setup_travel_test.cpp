// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_travel.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"

namespace endmill {
namespace {

Eigen::Matrix3d random_turn(test::Random& random)
{
    const auto number = [&] { return random.uniform(-1, 1); };
    return Eigen::Quaterniond{number(), number(), number(), number()}
        .normalized()
        .toRotationMatrix();
}

// The machine's axes in coordinates of a part that is turned by `turn`.
SetupPose pose_of(const RotaryFrame& home, const Eigen::Matrix3d& turn)
{
    return {turn.transpose() * home.tool_axis, turn.transpose() * home.r1_axis,
            turn.transpose() * home.r2_axis};
}

TEST(PartToMachine, IsTheRotationThatThePoseWasMadeFrom)
{
    test::Random random{1};
    for (const char* word : {"W/caBxyz/T", "W/xyzBcb/T", "W/aBbxyz/T", "W/baBxyz/T",
                             "W/axyBz/T", "W/xyBzb/T", "W/xyBz/T"}) {
        const MachineConfiguration machine = configuration_from_word(word);
        const Eigen::Matrix3d turn = random_turn(random);
        const SetupPose pose = pose_of(machine_frame(machine), turn);
        EXPECT_LT((part_to_machine(pose, machine) - turn).norm(), 1e-14) << word;
    }
    EXPECT_THROW(part_to_machine({}, configuration_from_word("W/acxyBz/T")), DomainError);
}

TEST(FacetReach, IsTheCellOfLeastTurnsOfEachFacet)
{
    test::Random random{2};
    const SphereGrid grid = sphere_grid("hex:4");
    VisibilityMap map{70, grid.centres.size()};
    for (std::size_t i = 0; i < map.cells(); ++i)
        for (std::size_t j = 1; j < map.facets(); ++j)  // no cell reaches facet 0
            if (random.uniform(0, 1) < 0.1)
                map.column(i)[j / 64] |= std::uint64_t{1} << (j % 64);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const MachineConfiguration configuration = configuration_of_family(family);
        const RotaryFrame frame = pose_frame(
            configuration, pose_of(machine_frame(configuration), random_turn(random)));
        const RotaryLimits limits{{-0.5, 1}, {-1, 0.7}};
        const auto reaches = facet_reach(map, grid.centres, frame, limits);
        EXPECT_FALSE(reaches[0]);
        for (std::size_t j = 0; j < map.facets(); ++j) {
            double least = 1e9;
            for (std::size_t i = 0; i < map.cells(); ++i) {
                if (!map.is_accessible(j, i))
                    continue;
                const RotaryAngles one = rotary_angles(frame, grid.centres[i]);
                const RotaryAngles other = other_rotary_angles(family, one);
                for (const auto& [phi, theta] : {one, other})
                    if (phi >= -0.5 && phi <= 1 && theta >= -1 && theta <= 0.7)
                        least = std::min(least, std::abs(phi) + std::abs(theta));
            }
            ASSERT_EQ(reaches[j].has_value(), least < 1e9) << j;
            if (!reaches[j])
                continue;
            const auto& [phi, theta] = reaches[j]->angles;
            EXPECT_NEAR(std::abs(phi) + std::abs(theta), least, 1e-12);
            EXPECT_LT((turned_tool_axis(frame, reaches[j]->angles) -
                       grid.centres[reaches[j]->cell])
                          .norm(),
                      1e-12);
        }
    }
}

// Facet 0 is reached, facet 1 has no area, and facet 2 is reached or has an empty cone.
TEST(ReachedPoints, AreCentroidsUnlessAFacetWithAnAreaIsMissed)
{
    const TriangleMesh part{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}},
                            {{0, 1, 2}, {0, 0, 1}, {0, 1, 3}}};
    const std::vector<Vec3> centres{Vec3::UnitZ(), Vec3::UnitX()};
    const RotaryFrame frame = machine_frame(configuration_of_family(RotaryFamily::CA));
    PartVisibility visibility{VisibilityMap{3, 2}, {1}};
    visibility.map.column(0)[0] = 0b001;
    EXPECT_FALSE(reached_points(part, visibility, centres, frame, {}));
    visibility.map.column(1)[0] = 0b100;
    const auto reached = reached_points(part, visibility, centres, frame, {});
    ASSERT_TRUE(reached);
    EXPECT_EQ(reached->points, (std::vector<Vec3>{{1, 1, 0}, {1, 0, 1}}));
    EXPECT_EQ(reached->angles[0].phi, 0);
    EXPECT_NEAR(std::abs(reached->angles[1].phi), std::numbers::pi / 2, 1e-15);
    EXPECT_FALSE(reached_points(part, visibility, centres, frame, {{-1, 1}, {-1, 1}}));
}

// A head that turns about C and A moves the tip about the pivot. The positions for a
// point that is reached straight down and at 90 degrees differ by the length of the arm,
// pivot plus tool.
TEST(SetupTravel, FollowsTheArmOfAHead)
{
    Machine machine{.configuration = configuration_from_word("W/xyzBca/T"), .pivot = 150};
    machine.linear[0] = {-10, 10};
    const ReachedPoints reached{{{1, 2, 3}, {1, 2, 3}},
                                {{0, 0}, {std::numbers::pi / 2, 0}}};
    const SetupTravel travel = setup_travel(machine, Eigen::Matrix3d::Identity(), reached,
                                            {4, 0, 0}, /*tool_length=*/50);
    EXPECT_LT((travel.low - Vec3{5, 2 - 200, 3 - 200}).norm(), 1e-12);
    EXPECT_LT((travel.high - Vec3{5, 2, 3}).norm(), 1e-12);
    EXPECT_TRUE(travel.is_within);
    // The middle of X is 0. Y and Z have no limits and are centred about 0.
    EXPECT_LT((travel.centred_clamp - Vec3{-1, -2 + 100, -3 + 100}).norm(), 1e-12);
}

TEST(SetupTravel, CentredClampIsTheLeastSquaresOne)
{
    test::Random random{3};
    Machine machine{.configuration = configuration_from_word("W/caBxyz/T"),
                    .table_offset = {3, -2, 7}};
    machine.linear = {LinearRange{-100, 300}, {-50, 70}, {0, 90}};
    ReachedPoints reached;
    for (int i = 0; i < 20; ++i) {
        reached.points.push_back(
            {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)});
        reached.angles.push_back({random.uniform(-1, 1), random.uniform(-3, 3)});
    }
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd{0.7, Vec3{1, 2, 3}.normalized()}.toRotationMatrix();
    const auto squares = [&](const Vec3& clamp) {
        double sum = 0;
        for (std::size_t i = 0; i < reached.points.size(); ++i) {
            const SetupTravel one = setup_travel(
                machine, turn, {{reached.points[i]}, {reached.angles[i]}}, clamp, 30);
            sum += (one.low - Vec3{100, 10, 45}).squaredNorm();
        }
        return sum;
    };
    const Vec3 centred =
        setup_travel(machine, turn, reached, Vec3::Zero(), 30).centred_clamp;
    const double least = squares(centred);
    for (int k = 0; k < 3; ++k)
        for (const double step : {-1e-3, 1e-3})
            EXPECT_GT(squares(centred + step * Vec3::Unit(k)), least);
    EXPECT_LT(squares(setup_travel(machine, turn, reached, {1, 1, 1}, 30).centred_clamp),
              least * (1 + 1e-12));
}

TEST(SetupTravel, NeedsPointsAndTheirTurns)
{
    const Machine machine{.configuration = configuration_from_word("W/caBxyz/T")};
    const Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    EXPECT_THROW(setup_travel(machine, turn, {}, Vec3::Zero(), 0), DomainError);
    EXPECT_THROW(setup_travel(machine, turn, {{{0, 0, 0}}, {}}, Vec3::Zero(), 0),
                 DomainError);
}

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
    SetupPart part() const { return {mesh, grid, visibility}; }
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
