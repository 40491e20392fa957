// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_travel.h"

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

// Along the tool axis C turns the tool about itself. It stays at 0, whatever the sign of
// the rounding errors of the direction.
TEST(FacetReach, DoesNotTurnTheAxisThatHasNoEffect)
{
    test::Random random{4};
    for (int i = 0; i < 200; ++i) {
        const RotaryFrame home = machine_frame(configuration_of_family(RotaryFamily::CA));
        const SetupPose pose = pose_of(home, random_turn(random));
        const RotaryFrame frame =
            pose_frame(configuration_of_family(RotaryFamily::CA), pose);
        VisibilityMap map{1, 1};
        map.column(0)[0] = 1;
        const std::vector<Vec3> centres{pose.tool_axis.normalized()};
        const auto reaches = facet_reach(map, centres, frame, {{-1, 1}, {0, 0}});
        ASSERT_TRUE(reaches[0]) << i;
        EXPECT_EQ(reaches[0]->angles.theta, 0) << i;
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

}  // namespace
}  // namespace endmill
