// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/kinematics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/machine/configuration.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

Machine machine_of(const std::string& word)
{
    Machine machine{.configuration = configuration_from_word(word)};
    machine.rotary = widest_limits(machine.configuration);
    return machine;
}

std::vector<Machine> valid_machines()
{
    std::vector<Machine> valid;
    for (const std::string& word : rotary_words()) {
        valid.push_back(machine_of(whole_word(word)));
        valid.back().pivot = 150;
        valid.back().table_offset = {3, -4, -70};
        if (!valid.back().configuration.is_valid())
            valid.pop_back();
    }
    return valid;
}

// Positions of three machines. Source: docs/methods/five-axis-setup.md, section 9
// (9.2).
struct PrintedPosition {
    const char* word;
    RotaryPositions degrees;
    Vec3 table_offset;
    Vec3 direction;
    Vec3 xyz;
};

TEST(Kinematics, GiveThePositionsOfTheTable)
{
    const Vec3 point{50, 20, 30};
    const Vec3 same{0.2716538, -0.3237444, 0.9063078};
    for (const PrintedPosition& row :
         {PrintedPosition{"W/cBaxyz/T",
                          {-40, 25},
                          {0, 0, 0},
                          same,
                          {51.1579743, -101.3421440, 11.2615574}},
          PrintedPosition{"W/Bcaxyz/T",
                          {40, 25},
                          {0, 0, 0},
                          same,
                          {104.3307565, -44.7488742, 11.2615574}},
          PrintedPosition{"W/baBxyz/T",
                          {30, -20},
                          {0, 0, -50},
                          {-0.4698463, -0.3420201, 0.8137977},
                          {83.3012702, 33.9391995, -15.2289039}}}) {
        Machine machine = machine_of(row.word);
        machine.table_offset = row.table_offset;
        const AxisPositions at = axis_positions(
            machine, {rad(row.degrees[0]), rad(row.degrees[1])}, point, 200);
        EXPECT_LT((at.xyz - row.xyz).norm(), 1e-7) << row.word;
        EXPECT_LT((tool_location(machine, at, 200).axis - row.direction).norm(), 1e-7)
            << row.word;
    }
}

// The joints of a machine as a chain from part to bed and from bed to tool. A point and a
// direction are moved along the chain axis by axis.
struct Carried {
    Vec3 point;
    Vec3 axis;
};

Carried carried_by_hand(const Machine& machine, const RotaryPositions& rotary, Vec3 point,
                        double length)
{
    const auto turn = [](char letter, double angle, const Vec3& v) -> Vec3 {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        if (letter == 'a')
            return {v.x(), c * v.y() - s * v.z(), s * v.y() + c * v.z()};
        if (letter == 'b')
            return {c * v.x() + s * v.z(), v.y(), -s * v.x() + c * v.z()};
        return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
    };
    const auto& axes = machine.configuration.rotary;
    point -= machine.table_offset;
    for (std::size_t k = 0; k < axes.size();
         ++k)  // the axis nearest to the part acts first
        if (axes[k].side == MachineSide::Table)
            point = turn(axes[k].letter, rotary[k], point);
    Vec3 axis = Vec3::UnitZ();
    for (std::size_t k = axes.size();
         k-- > 0;)  // the axis nearest to the tool acts first
        if (axes[k].side == MachineSide::Head)
            axis = turn(axes[k].letter, rotary[k], axis);
    const Vec3 shift = (machine.pivot + length) * (axis - Vec3::UnitZ());
    for (std::size_t k = axes.size();
         k-- > 0;)  // back to the part: inverse turns, from the bed
        if (axes[k].side == MachineSide::Table)
            axis = turn(axes[k].letter, -rotary[k], axis);
    return {point + machine.table_offset + shift, axis};
}

TEST(Kinematics, AreThoseOfTheChainOfJoints)
{
    test::Random random{1};
    for (const Machine& machine : valid_machines())
        for (int k = 0; k < 200; ++k) {
            const RotaryPositions rotary{random.uniform(-pi, pi),
                                         random.uniform(-pi, pi)};
            const Vec3 point{random.uniform(-99, 99), random.uniform(-99, 99),
                             random.uniform(-99, 99)};
            const AxisPositions at = axis_positions(machine, rotary, point, 80);
            const Carried expected = carried_by_hand(machine, rotary, point, 80);
            EXPECT_LT((at.xyz - expected.point).norm(), 1e-12)
                << machine.configuration.word;
            const CutterLocation seen = tool_location(machine, at, 80);
            EXPECT_LT((seen.tip - point).norm(), 1e-12) << machine.configuration.word;
            EXPECT_LT((seen.axis - expected.axis).norm(), 1e-14)
                << machine.configuration.word;
        }
}

TEST(Kinematics, AtZeroGiveTheCoordinatesOfThePoint)
{
    for (const Machine& machine : valid_machines())
        EXPECT_LT(
            (axis_positions(machine, {0, 0}, {1, 2, 3}, 9).xyz - Vec3(1, 2, 3)).norm(),
            1e-14);
}

// Forward kinematics after inverse kinematics gives the direction, for both solutions.
TEST(RotarySolutions, GiveTheDirection)
{
    test::Random random{2};
    for (const Machine& machine : valid_machines())
        for (int k = 0; k < 500; ++k) {
            const Vec3 direction{random.uniform(-1, 1), random.uniform(-1, 1),
                                 random.uniform(-1, 1)};
            const auto solutions = rotary_solutions(machine, direction);
            ASSERT_EQ(solutions.size(), 2U);
            EXPECT_NE(solutions[0].positions, solutions[1].positions);
            for (const RotarySolution& solution : solutions) {
                const AxisPositions at =
                    axis_positions(machine, solution.positions, {5, 6, 7}, 100);
                const CutterLocation seen = tool_location(machine, at, 100);
                EXPECT_LT((seen.axis - direction.normalized()).norm(), 1e-14);
                EXPECT_TRUE(solution.is_within_limits);
                EXPECT_TRUE(is_within_travel(machine, at));
            }
        }
}

TEST(RotarySolutions, AreMovedIntoTheLimitsByWholeTurns)
{
    Machine machine = machine_of("W/Bcaxyz/T");
    machine.rotary = {.phi = {0, rad(100)}, .theta = {rad(-300), 0}};
    const auto solutions = rotary_solutions(
        machine, turned_tool_axis(machine_frame(machine.configuration), {1, 2}));
    EXPECT_NEAR(solutions[0].positions[0], 2 - 2 * pi, 1e-14);
    EXPECT_NEAR(solutions[0].positions[1], 1, 1e-14);
    EXPECT_TRUE(solutions[0].is_within_limits);
    EXPECT_FALSE(solutions[1].is_within_limits);  // the tilt would be negative
}

TEST(RotarySolutions, AtThePoleHaveNoNeedlessTurn)
{
    for (const Machine& machine : valid_machines()) {
        const auto solutions = rotary_solutions(machine, {0, 0, 2});
        EXPECT_NEAR(solutions[0].positions[0], 0, 1e-15) << machine.configuration.word;
        EXPECT_NEAR(solutions[0].positions[1], 0, 1e-15);
    }
    const auto along_r1 = rotary_solutions(machine_of("W/Babxyz/T"), {1, 1e-12, 0});
    EXPECT_EQ(along_r1[0].positions[0], 0);
    EXPECT_NEAR(along_r1[0].positions[1], pi / 2, 1e-11);
}

TEST(RotarySolutions, OfFewerAxesAreOneOrNone)
{
    const Machine four = machine_of("W/axyBz/T");
    const auto found = rotary_solutions(four, {0, -std::sin(0.4), std::cos(0.4)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].positions[0], -0.4, 1e-15);  // the sign changes in a table
    EXPECT_TRUE(rotary_solutions(four, {0.1, 0, 1}).empty());
    const Machine three = machine_of("W/xyBz/T");
    EXPECT_EQ(rotary_solutions(three, {0, 0, 1}).size(), 1U);
    EXPECT_TRUE(rotary_solutions(three, {0, 0.1, 1}).empty());
    EXPECT_TRUE(rotary_solutions(three, {0, 0, -1}).empty());
}

TEST(RotarySolutions, NeedADirectionAndAMachine)
{
    const Machine machine = machine_of("W/caxyBz/T");
    EXPECT_THROW(rotary_solutions(machine, {0, 0, 0}), DomainError);
    EXPECT_THROW(rotary_solutions(machine, {0, std::nan(""), 1}), DomainError);
    EXPECT_THROW(
        rotary_solutions(Machine{configuration_from_word("W/acxyBz/T")}, {0, 0, 1}),
        DomainError);
    EXPECT_EQ(rotary_solutions(machine, {0, 1e-300, 1e-300}).size(), 2U);
}

TEST(Travel, LimitsEveryAxis)
{
    Machine machine = machine_of("W/cxyBza/T");
    machine.rotary.phi = {rad(-20), rad(100)};
    machine.linear[2] = {-300, 0};
    EXPECT_TRUE(is_within_travel(machine, {{rad(720), rad(100)}, {0, 0, -300}}));
    EXPECT_FALSE(is_within_travel(machine, {{0, rad(101)}, {0, 0, -300}}));
    EXPECT_FALSE(is_within_travel(machine, {{0, rad(360)}, {0, 0, -300}}));
    EXPECT_FALSE(is_within_travel(machine, {{0, 0}, {0, 0, 1}}));
    machine.rotary.theta = {rad(-10), rad(30)};  // turns of a table: positions -30 to 10
    EXPECT_TRUE(is_within_travel(machine, {{rad(-30), 0}, {0, 0, 0}}));
    EXPECT_FALSE(is_within_travel(machine, {{rad(30), 0}, {0, 0, 0}}));
}

// Checks [1] and [2] of docs/methods/five-axis-paths.md, section 9: positions of all words
// with table offset, tool length and the offset between axes, found by an independent
// program.
struct WordPosition {
    const char* word;
    Vec3 axis;
    Vec3 xyz;
};

TEST(Kinematics, GiveThePositionsOfAllWords)
{
    for (const WordPosition& row : {
             WordPosition{"abB",
                          {-.422618, -.582563, .694272},
                          {44.600341, 25.896165, -10.555865}},
             {"aBb", {.422618, -.582563, .694272}, {134.523652, 25.896165, -10.538864}},
             {"Bab", {.422618, .582563, .694272}, {134.523652, 136.512683, -31.145591}},
             {"baB", {.582563, .422618, .694272}, {27.259035, -.905253, 61.817216}},
             {"bBa", {.582563, -.422618, .694272}, {27.259035, -64.523652, 35.741844}},
             {"Bba", {-.582563, -.422618, .694272}, {-66.512683, -64.523652, -31.145591}},
             {"caB", {-.271654, .323744, .906308}, {56.827265, -22.499756, 24.736526}},
             {"cBa", {.271654, -.323744, .906308}, {56.827265, -99.765895, 11.261557}},
             {"Bca", {-.271654, -.323744, .906308}, {-4.330756, -44.748874, 11.261557}},
             {"cbB", {-.323744, -.271654, .906308}, {60.001201, -15.242242, 6.316699}},
             {"cBb", {.323744, .271654, .906308}, {141.350918, -15.242242, 11.261557}},
             {"Bcb", {.323744, -.271654, .906308}, {114.748874, -34.330756, 11.261557}},
         }) {
        Machine machine = machine_of(whole_word(row.word));
        machine.table_offset = {5, -7, 11};
        const AxisPositions at =
            axis_positions(machine, {rad(-40), rad(25)}, {50, 20, 30}, 200);
        EXPECT_LT((at.xyz - row.xyz).lpNorm<Eigen::Infinity>(), 1e-6) << row.word;
        const CutterLocation seen = tool_location(machine, at, 200);
        EXPECT_LT((seen.axis - row.axis).lpNorm<Eigen::Infinity>(), 1e-6) << row.word;
        EXPECT_LT((seen.tip - Vec3{50, 20, 30}).norm(), 1e-12) << row.word;
    }
}

TEST(Kinematics, TurnAboutLinesThatDoNotMeet)
{
    Machine table = machine_of("W/caBxyz/T");
    table.axis_offset = {0, 12, -8};
    const Vec3 point{40, 15, 20};
    const RotaryPositions rotary{rad(50), rad(-35)};
    const Vec3 on_table = axis_positions(table, rotary, point, 200).xyz;
    EXPECT_LT((on_table - Vec3{14.220838, 51.228702, -1.286545}).norm(), 1.5e-6);
    Machine head = machine_of("W/Bcbxyz/T");
    head.axis_offset = {15, 0, 0};
    const Vec3 by_head = axis_positions(head, rotary, point, 200).xyz;
    EXPECT_LT((by_head - Vec3{-28.379379, -84.367675, -16.169591}).norm(), 1.5e-6);
}

// Check [3]: the forward kinematics of LinuxCNC's five-axis machines. The formulas state
// the tip for given positions, with words in degrees.
struct Words {
    Vec3 xyz;
    double tilt;
    double turn;
};

// xyzac-trt: a tilting table A that carries C; y and z offset between their lines.
Vec3 xyzac_tip(const Words& at, const Vec3& centre, const Vec3& offset)
{
    const double sa = std::sin(rad(at.tilt));
    const double ca = std::cos(rad(at.tilt));
    const double sc = std::sin(rad(at.turn));
    const double cc = std::cos(rad(at.turn));
    const double x = at.xyz.x() - centre.x();
    const double y = at.xyz.y() - offset.y() - centre.y();
    const double z = at.xyz.z() - offset.z() - centre.z();
    return {cc * x + sc * (ca * y + sa * z + offset.y()) + centre.x(),
            -sc * x + cc * (ca * y + sa * z + offset.y()) + centre.y(),
            -sa * y + ca * z + offset.z() + centre.z()};
}

// xyzbc-trt: the same with B.
Vec3 xyzbc_tip(const Words& at, const Vec3& centre, const Vec3& offset)
{
    const double sb = std::sin(rad(at.tilt));
    const double cb = std::cos(rad(at.tilt));
    const double sc = std::sin(rad(at.turn));
    const double cc = std::cos(rad(at.turn));
    const double x = at.xyz.x() - offset.x() - centre.x();
    const double y = at.xyz.y() - centre.y();
    const double z = at.xyz.z() - offset.z() - centre.z();
    return {cc * (cb * x - sb * z + offset.x()) + sc * y + centre.x(),
            -sc * (cb * x - sb * z + offset.x()) + cc * y + centre.y(),
            sb * x + cb * z + offset.z() + centre.z()};
}

TEST(Kinematics, AreThoseOfLinuxCncsTiltingTables)
{
    test::Random random{7};
    const auto vector = [&](double most) {
        return Vec3{random.uniform(-most, most), random.uniform(-most, most),
                    random.uniform(-most, most)};
    };
    for (const char letter : {'a', 'b'})
        for (int k = 0; k < 1000; ++k) {
            Machine machine = machine_of(whole_word(std::string{"c"} + letter + "B"));
            machine.table_offset = vector(100);
            machine.axis_offset = vector(30);
            machine.axis_offset[letter - 'a'] = 0;
            const Words at{vector(200), random.uniform(-120, 120),
                           random.uniform(-400, 400)};
            const Vec3 expected =
                letter == 'a' ? xyzac_tip(at, machine.table_offset, machine.axis_offset)
                              : xyzbc_tip(at, machine.table_offset, machine.axis_offset);
            const Vec3 tip =
                tool_location(machine, {{rad(at.turn), rad(at.tilt)}, at.xyz}, 50).tip;
            EXPECT_LT((tip - expected).norm(), 1e-9);
        }
}

// maxkins: a table C and a head B, whose words have the opposite sign of the positions.
// 5axiskins: a head that turns about C and tilts about B, with the opposite word B.
TEST(Kinematics, AreThoseOfLinuxCncsTiltingHeads)
{
    test::Random random{8};
    const Machine max = machine_of("W/cxyzBb/T");
    const Machine bridge = machine_of("W/xyzBcb/T");
    for (int k = 0; k < 1000; ++k) {
        const Vec3 xyz{random.uniform(-200, 200), random.uniform(-200, 200),
                       random.uniform(-200, 200)};
        const double b = random.uniform(-110, 110);
        const double c = random.uniform(-400, 400);
        const double length = random.uniform(50, 300);
        const double across = xyz.x() + length * std::sin(rad(b));
        const double radius = std::hypot(across, xyz.y());
        const double azimuth = std::atan2(xyz.y(), across) + rad(c);
        const Vec3 max_tip{radius * std::cos(azimuth), radius * std::sin(azimuth),
                           xyz.z() - length * std::cos(rad(b)) + length};
        EXPECT_LT(
            (tool_location(max, {{-rad(c), -rad(b)}, xyz}, length).tip - max_tip).norm(),
            1e-9);
        const Vec3 bridge_tip = xyz + length * Vec3{std::sin(rad(b)) * std::cos(rad(c)),
                                                    std::sin(rad(b)) * std::sin(rad(c)),
                                                    1 - std::cos(rad(b))};
        EXPECT_LT(
            (tool_location(bridge, {{rad(c), -rad(b)}, xyz}, length).tip - bridge_tip)
                .norm(),
            1e-9);
    }
}

PartOnMachine random_setup(const Machine& machine, test::Random& random)
{
    PartOnMachine setup{.machine = machine,
                        .tool_length = random.uniform(20, 200),
                        .part_to_machine = Eigen::Matrix3d::Identity(),
                        .clamp = {random.uniform(-50, 50), random.uniform(-50, 50), 30}};
    const Vec3 line = Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 1}.normalized();
    setup.part_to_machine =
        Eigen::AngleAxisd{random.uniform(-3, 3), line}.toRotationMatrix();
    const auto& rotary = machine.configuration.rotary;
    if (rotary.size() == 2 && rotary[0].side == rotary[1].side)
        setup.machine.axis_offset = {random.uniform(-30, 30), random.uniform(-30, 30),
                                     random.uniform(-30, 30)};
    return setup;
}

// Check [4]: inverse, then forward kinematics, by both solutions.
TEST(PartOnMachine, HasPositionsForEveryPose)
{
    test::Random random{3};
    for (const Machine& machine : valid_machines())
        for (int k = 0; k < 200; ++k) {
            const PartOnMachine setup = random_setup(machine, random);
            const Vec3 tip{random.uniform(-99, 99), random.uniform(-99, 99),
                           random.uniform(-99, 99)};
            const Vec3 axis =
                Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}
                    .normalized();
            const auto solutions = rotary_solutions(setup, axis);
            ASSERT_EQ(solutions.size(), 2U);
            for (const RotarySolution& solution : solutions) {
                const CutterLocation seen =
                    tool_location(setup, axis_positions(setup, solution.positions, tip));
                EXPECT_LT((seen.tip - tip).norm(), 1e-12 * 400);
                EXPECT_LT((seen.axis - axis).norm(), 1e-12);
            }
        }
}

// With all rotary axes at zero X, Y, Z are the clamped point.
TEST(PartOnMachine, AtZeroStandsWhereItIsClamped)
{
    test::Random random{4};
    for (const Machine& machine : valid_machines()) {
        const PartOnMachine setup = random_setup(machine, random);
        const Vec3 point{1, 2, 3};
        EXPECT_LT((axis_positions(setup, {0, 0}, point).xyz -
                   (setup.part_to_machine * point + setup.clamp))
                      .norm(),
                  1e-13);
    }
}

// The derivatives of the tip agree with differences of positions.
TEST(TipMotion, HasTheDerivativesOfTheTip)
{
    test::Random random{5};
    const auto number = [&](double most) { return random.uniform(-most, most); };
    for (const Machine& machine : valid_machines())
        for (int k = 0; k < 50; ++k) {
            const PartOnMachine setup = random_setup(machine, random);
            const AxisPositions at{{number(3), number(3)},
                                   {number(99), number(99), number(99)}};
            const AxisPositions rates{{number(1), number(1)},
                                      {number(50), number(50), number(50)}};
            const auto tip = [&](double u) {
                return tool_location(setup, {{at.rotary[0] + u * rates.rotary[0],
                                              at.rotary[1] + u * rates.rotary[1]},
                                             at.xyz + u * rates.xyz})
                    .tip;
            };
            const TipMotion motion = tip_motion(setup, at, rates);
            constexpr double step = 1e-3;
            EXPECT_LT((motion.tip - tip(0)).norm(), 1e-11);
            // Errors of central differences: step^2 / 6 times the third derivative, below
            // 1e4 here, and step^2 / 12 times the fourth, below 3e4.
            EXPECT_LT((motion.velocity - (tip(step) - tip(-step)) / (2 * step)).norm(),
                      2e-3);
            EXPECT_LT((motion.acceleration -
                       (tip(step) - 2 * tip(0) + tip(-step)) / (step * step))
                          .norm(),
                      5e-3);
        }
}

TEST(Travel, OfAWideAxisIsThatOfItsFile)
{
    Machine machine = machine_of("W/caBxyz/T");
    EXPECT_TRUE(std::isinf(position_range(machine, 0).to));
    machine.wide_positions[0] = RotaryRange{rad(-720), rad(360)};
    EXPECT_EQ(position_range(machine, 0), (RotaryRange{rad(-720), rad(360)}));
    EXPECT_TRUE(is_within_travel(machine, {{rad(-700), 0}, {0, 0, 0}}));
    EXPECT_FALSE(is_within_travel(machine, {{rad(361), 0}, {0, 0, 0}}));
    machine.rotary.phi = {rad(-30), rad(100)};  // A is a table: positions -100 to 30
    EXPECT_NEAR(position_range(machine, 1).from, rad(-100), 1e-15);
    EXPECT_NEAR(position_range(machine, 1).to, rad(30), 1e-15);
}

// Check [5]: the middle of the great arc from z to x.
TEST(AxisOnArc, TurnsEvenly)
{
    const Vec3 middle = axis_on_arc(Vec3::UnitZ(), Vec3::UnitX(), 0.5);
    EXPECT_LT((middle - Vec3(1, 0, 1) / std::sqrt(2)).norm(), 1e-15);
    test::Random random{6};
    for (int k = 0; k < 300; ++k) {
        const Vec3 from =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 1}.normalized();
        const Vec3 to =
            Vec3{random.uniform(-1, 1), 1, random.uniform(-1, 1)}.normalized();
        const double whole = angle_between(from, to);
        EXPECT_NEAR(whole, std::acos(from.dot(to)), 1e-7);
        const double u = random.uniform(0, 1);
        const Vec3 axis = axis_on_arc(from, to, u);
        EXPECT_NEAR(axis.norm(), 1, 1e-15);
        EXPECT_NEAR(angle_between(from, axis), u * whole, 1e-14);
        EXPECT_NEAR(angle_between(axis, to), (1 - u) * whole, 1e-14);
    }
}

TEST(AxisOnArc, OfEqualAxesIsThatAxis)
{
    const Vec3 axis = Vec3{1, 2, 3}.normalized();
    EXPECT_LT((axis_on_arc(axis, axis, 0.3) - axis).norm(), 1e-15);
    const Vec3 near = (axis + Vec3{1e-9, 0, 0}).normalized();
    EXPECT_LT(angle_between(axis_on_arc(axis, near, 0.5), axis), 1e-9);
}

TEST(Interpolation, HasTheWordsOfTheSummary)
{
    for (const Interpolation interpolation :
         {Interpolation::Linear, Interpolation::Tcp, Interpolation::Joint})
        EXPECT_EQ(interpolation_from_name(interpolation_name(interpolation)),
                  interpolation);
    EXPECT_EQ(interpolation_name(Interpolation::Tcp), "tcp");
    EXPECT_FALSE(interpolation_from_name("cubic"));
}

}  // namespace
}  // namespace endmill
