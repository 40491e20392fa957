// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/tool_motion.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

Vec3 random_place(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

// A move of up to a few mm and half a radian, as a piece of a path or a whole coarse move.
ToolMotion random_motion(test::Random& random)
{
    const CutterLocation from{random_place(random, 50),
                              random_place(random, 1).normalized()};
    const double turn = random.uniform(0, 0.5);
    const Vec3 to = (from.axis + turn * random_place(random, 1)).normalized();
    return {from, {from.tip + random_place(random, 5), to}};
}

TEST(ToolMotion, TurnsTheAxisEvenlyOnTheGreatArc)
{
    const ToolMotion motion{{{0, 0, 0}, {0, 0, 1}}, {{4, 0, 2}, {1, 0, 0}}};
    const CutterLocation middle = motion.location(0.5);
    EXPECT_LE((middle.axis - Vec3{1, 0, 1}.normalized()).norm(), 1e-15);
    EXPECT_LE((middle.tip - Vec3{2, 0, 1}).norm(), 1e-15);
    EXPECT_DOUBLE_EQ(motion.turn(), std::acos(0.0));
    const CutterLocation third = motion.location(1 / 3.0);
    EXPECT_NEAR(third.axis.z(), std::cos(motion.turn() / 3), 1e-15);
}

TEST(ToolMotion, EndsAtTheGivenLocations)
{
    test::Random random{1};
    for (int i = 0; i < 100; ++i) {
        const CutterLocation from{random_place(random, 9),
                                  random_place(random, 1).normalized()};
        const CutterLocation to{random_place(random, 9),
                                random_place(random, 1).normalized()};
        const ToolMotion motion{from, to};
        EXPECT_LE((motion.location(0).axis - from.axis).norm(), 1e-14);
        EXPECT_LE((motion.location(1).axis - to.axis).norm(), 1e-14);
        EXPECT_EQ(motion.location(1).tip, to.tip);
    }
}

TEST(ToolMotion, ChordErrorIsConvex)
{
    test::Random random{5};
    for (int i = 0; i < 1000; ++i) {
        const ToolMotion motion = random_motion(random);
        const Vec3 from = motion.from().tip + random_place(random, 40);
        const Vec3 to = motion.from().tip + random_place(random, 40);
        for (int k = 0; k <= 10; ++k) {
            const double share = k / 10.0;
            EXPECT_LE(motion.chord_error((1 - share) * from + share * to),
                      (1 - share) * motion.chord_error(from) +
                          share * motion.chord_error(to) + 1e-14);
        }
    }
}

// Seen from the tool, the frame neither slips nor turns about the axis: its y'' from the
// formula of `chord_error` agrees with a second difference.
TEST(ToolMotion, SeenPlacesStayWithinTheChordError)
{
    test::Random random{2};
    double least_ratio = 1e9;
    for (int i = 0; i < 10'000; ++i) {
        const ToolMotion motion = random_motion(random);
        const Vec3 place = motion.from().tip + random_place(random, 40);
        const Vec3 from = motion.seen(place, 0);
        const Vec3 to = motion.seen(place, 1);
        double error = 0;
        for (int k = 1; k < 16; ++k) {
            const double u = k / 16.0;
            error =
                std::max(error, (motion.seen(place, u) - (1 - u) * from - u * to).norm());
        }
        const double bound = motion.chord_error(place);
        EXPECT_LE(error, bound + 1e-12);
        if (error > 1e-6)
            least_ratio = std::min(least_ratio, bound / error);
    }
    // The bound is close: for small turns it is the second derivative at the middle.
    EXPECT_LT(least_ratio, 1.1);
}

TEST(ToolMotion, HalvesFollowTheWhole)
{
    test::Random random{3};
    for (int i = 0; i < 200; ++i) {
        const ToolMotion motion = random_motion(random);
        const Vec3 place = random_place(random, 40);
        const auto halves = motion.halves();
        for (const double u : {0.0, 0.3, 1.0}) {
            EXPECT_LE((halves[0].seen(place, u) - motion.seen(place, u / 2)).norm(),
                      1e-12);
            EXPECT_LE((halves[1].seen(place, u) - motion.seen(place, (1 + u) / 2)).norm(),
                      1e-12);
        }
        EXPECT_LE(halves[0].chord_error(place) + halves[1].chord_error(place),
                  motion.chord_error(place) * 0.9 + 1e-12);
    }
}

TEST(ToolMotion, WithoutATurnHasNoChordError)
{
    const Vec3 axis = Vec3{1, 2, 3}.normalized();
    const ToolMotion motion{{{0, 0, 0}, axis}, {{7, -1, 2}, axis}};
    EXPECT_EQ(motion.chord_error({100, 0, 3}), 0);
    EXPECT_EQ(motion.turn(), 0);
}

TEST(ToolMotion, BoundsTheWayOfPlacesOnTheAxis)
{
    test::Random random{4};
    for (int i = 0; i < 500; ++i) {
        const ToolMotion motion = random_motion(random);
        const double height = random.uniform(0, 100);
        const auto at = [&](double u) -> Vec3 {
            const CutterLocation here = motion.location(u);
            return here.tip + height * here.axis;
        };
        for (const double u : {0.25, 0.5, 0.8})
            EXPECT_LE((at(u) - (1 - u) * at(0) - u * at(1)).norm(),
                      motion.largest_tool_bend(height) / 8 + 1e-12);
    }
}

// A machine of any word, with offsets, and a move of up to a few mm and some tenths of a
// radian.
struct MachineCase {
    MachineCase(test::Random& random, const std::string& word, bool has_offset)
    {
        setup.machine.configuration = configuration_from_word(word);
        setup.machine.pivot = random.uniform(0, 80);
        setup.machine.table_offset = random_place(random, 30);
        const auto& rotary = setup.machine.configuration.rotary;
        if (has_offset && rotary.size() == 2 && rotary[0].side == rotary[1].side)
            setup.machine.axis_offset = random_place(random, 10);
        setup.tool_length = random.uniform(0, 50);
        setup.part_to_machine =
            frame_at({{0, 0, 0}, random_place(random, 1).normalized()}).axes;
        setup.clamp = random_place(random, 20);
        for (std::size_t k = 0; k < rotary.size(); ++k) {
            from.rotary[k] = random.uniform(-3, 3);
            to.rotary[k] = from.rotary[k] + random.uniform(-0.3, 0.3);
        }
        from.xyz = random_place(random, 40);
        to.xyz = from.xyz + random_place(random, 5);
    }

    PartOnMachine setup;
    AxisPositions from;
    AxisPositions to;
};

std::vector<std::string> words()
{
    std::vector<std::string> some;
    for (const std::string& word : rotary_words())
        some.push_back(whole_word(word));
    some.emplace_back("W/aBxyz/T");
    some.emplace_back("W/Bxyza/T");
    return some;
}

TEST(ToolMotion, OfAMachineAgreesWithItsKinematics)
{
    test::Random random{5};
    for (const std::string& word : words())
        for (int i = 0; i < 20; ++i) {
            const MachineCase one{random, word, i % 2 == 0};
            const ToolMotion motion{one.setup, Interpolation::Joint, one.from, one.to};
            for (const double u : {0.0, 0.4, 1.0}) {
                AxisPositions at;
                for (std::size_t k = 0; k < 2; ++k)
                    at.rotary[k] = (1 - u) * one.from.rotary[k] + u * one.to.rotary[k];
                at.xyz = (1 - u) * one.from.xyz + u * one.to.xyz;
                const CutterLocation exact = tool_location(one.setup, at);
                EXPECT_LE((motion.location(u).tip - exact.tip).norm(), 1e-12);
                EXPECT_LE((motion.location(u).axis - exact.axis).norm(), 1e-14);
            }
        }
}

TEST(ToolMotion, OfAMachineStaysWithinTheChordError)
{
    test::Random random{6};
    for (const std::string& word : words())
        for (int i = 0; i < 500; ++i) {
            const MachineCase one{random, word, i % 2 == 0};
            const ToolMotion motion{one.setup,
                                    i % 4 < 2 ? Interpolation::Joint : Interpolation::Tcp,
                                    one.from, one.to};
            const Vec3 place = motion.from().tip + random_place(random, 30);
            const Vec3 from = motion.seen(place, 0);
            const Vec3 to = motion.seen(place, 1);
            const Vec3 on_tool = random_place(random, 40);
            const auto in_part = [&](double u) -> Vec3 {
                const ToolFrame frame = motion.at(u);
                return frame.tip + frame.axes * on_tool;
            };
            for (const double u : {0.2, 0.5, 0.7}) {
                EXPECT_LE((motion.seen(place, u) - (1 - u) * from - u * to).norm(),
                          motion.chord_error(place) + 1e-12);
                EXPECT_LE((in_part(u) - (1 - u) * in_part(0) - u * in_part(1)).norm(),
                          motion.largest_tool_bend(on_tool.norm()) / 8 + 1e-12);
                const Vec3 axis = motion.location(u).axis;
                const Vec3 chord =
                    (1 - u) * motion.location(0).axis + u * motion.location(1).axis;
                EXPECT_LE((axis - chord).norm(), motion.axis_sag() + 1e-14);
            }
        }
}

TEST(ToolMotion, HalvesOfAMachinesMotionFollowTheWhole)
{
    test::Random random{7};
    for (const std::string& word : words())
        for (const Interpolation kind : {Interpolation::Joint, Interpolation::Tcp}) {
            const MachineCase one{random, word, true};
            const ToolMotion motion{one.setup, kind, one.from, one.to};
            const Vec3 place = random_place(random, 40);
            const auto halves = motion.halves();
            for (const double u : {0.0, 0.3, 1.0}) {
                EXPECT_LE((halves[0].seen(place, u) - motion.seen(place, u / 2)).norm(),
                          1e-11);
                EXPECT_LE(
                    (halves[1].seen(place, u) - motion.seen(place, (1 + u) / 2)).norm(),
                    1e-11);
            }
            EXPECT_NEAR(halves[0].turn() + halves[1].turn(), motion.turn(), 1e-14);
        }
}

TEST(ToolMotion, RefusesOppositeAxesAndNonsense)
{
    EXPECT_THROW((ToolMotion{{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, -1}}}),
                 DomainError);
    EXPECT_THROW((ToolMotion{{{0, 0, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, 2}}}),
                 DomainError);
    EXPECT_THROW((ToolMotion{{{0, 0, NAN}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, 1}}}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
