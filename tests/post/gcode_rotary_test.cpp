// SPDX-License-Identifier: GPL-3.0-or-later
// Programs with rotary words, written and read back.
#include "endmill/post/gcode_reader.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/post/machine_gcode.h"
#include "endmill/post/machine_path.h"
#include "five_axis.h"

namespace endmill {
namespace {

using test::cone_path;
using test::direction;
using test::part_on;
using testing::Contains;
using testing::HasSubstr;

GcodeReadOptions reading_of(const PartOnMachine& setup,
                            Interpolation frame = Interpolation::Joint)
{
    GcodeReadOptions options;
    options.rotary = RotaryReading{.setup = setup, .frame = frame};
    return options;
}

// The path between the first and the last move at feed, without the safe start and end.
struct Kept {
    std::vector<PathPoint> points;
    std::vector<AxisPositions> positions;
};

Kept cut_of(const ToolPath& path)
{
    Kept kept;
    for (std::size_t i = 0; i < path.points.size(); ++i)
        if (path.points[i].move != Move::Rapid) {
            kept.points.push_back(path.points[i]);
            kept.positions.push_back(path.machine->positions[i]);
        }
    return kept;
}

// Check [7]: written and read back, all words, in both frames. With d decimals the tip is off
// by at most sqrt(3)/2 10^-d and the axis by 10^-e degrees for each rounded angle.
TEST(RotaryPrograms, GiveBackThePoses)
{
    test::Random random{51};
    for (const Interpolation frame : {Interpolation::Joint, Interpolation::Tcp})
        for (int k = 0; k < 60; ++k) {
            PartOnMachine setup = test::random_part_on_machine(random, true);
            setup.machine.word_signs = {k % 2 == 0 ? 1.0 : -1.0, 1};
            std::vector<CutterLocation> poses;
            for (int i = 0; i < 5; ++i)
                poses.push_back(
                    {test::random_vector(random, 40),
                     (direction(setup, 25, 10) + test::random_vector(random, 0.3))
                         .normalized()});
            const MachinePath made =
                machine_path(test::path_through(poses), setup, {.frame = frame});
            for (const int digits : {4, 6}) {
                const double unit = std::pow(10, -digits);
                const std::string text =
                    machine_gcode(made, {.decimals = digits}, {.angle_decimals = digits})
                        .program.text;
                const Kept read =
                    cut_of(parse_gcode(text, "f.ngc", reading_of(setup, frame)).path);
                ASSERT_EQ(read.points.size(), made.path.points.size());
                for (std::size_t i = 0; i < read.points.size(); ++i) {
                    const CutterLocation& expected = made.path.points[i].location;
                    const CutterLocation& found = read.points[i].location;
                    EXPECT_LE((found.tip - expected.tip).norm(),
                              std::sqrt(3) / 2 * unit * (1 + 1e-6));
                    EXPECT_LE(angle_between(found.axis, expected.axis), test::rad(unit));
                    for (std::size_t axis = 0; axis < 2; ++axis)
                        EXPECT_NEAR(read.positions[i].rotary[axis],
                                    made.path.machine->positions[i].rotary[axis],
                                    test::rad(unit));
                }
            }
        }
}

// The feed of the tip is given back: T from F, then way / T.
TEST(RotaryPrograms, GiveBackTheFeedOfTheTip)
{
    PartOnMachine setup = part_on("caB");
    setup.tool_length = 100;
    const MachinePath made = machine_path(cone_path(30, 10, 24), setup);
    const std::string text = machine_gcode(made, {}).program.text;
    const Kept read = cut_of(parse_gcode(text, "f.ngc", reading_of(setup)).path);
    for (std::size_t i = 1; i < read.points.size(); ++i)
        EXPECT_NEAR(read.points[i].conditions.feed_mm_per_min.value_or(0), 600, 0.2);
}

std::string head(const std::string& lines)
{
    return "G21 G90 G94\nG0 A0 C0\nG0 X0 Y0 Z0\n" + lines + "M2\n";
}

ToolPath path_of(const std::string& lines, const PartOnMachine& setup,
                 Interpolation frame = Interpolation::Joint)
{
    return parse_gcode(head(lines), "f.ngc", reading_of(setup, frame)).path;
}

// Check [8]: under G94 F counts X, Y and Z, or without them the rotary axes in degrees.
TEST(RotaryPrograms, TimeMovesByTheirFeed)
{
    const PartOnMachine setup = part_on("caB");
    // 5 mm at 150 mm/min: 1/30 min, as F30 under G93.
    for (const std::string line : {"G1 Y5 F150\n", "G93 G1 Y5 F30\nG94\n"})
        EXPECT_NEAR(
            path_of(line, setup).points.back().conditions.feed_mm_per_min.value_or(0),
            150, 1e-9);
    // A by 10 and C by 380 degrees at the rate that rs274 prints for F10 under G93: the
    // axis turns by 10 degrees in 1/10 min.
    GcodeReadOptions options = reading_of(setup);
    options.rotary->cutter_radius = 10;
    for (const std::string line :
         {"G1 A10 C380 F3801.3156\n", "G93 G1 A10 C380 F10\nG94\n"}) {
        const ToolPath path = parse_gcode(head(line), "f.ngc", options).path;
        EXPECT_NEAR(path.points.back().conditions.feed_mm_per_min.value_or(0),
                    10 * test::rad(10) * 10, 1e-6);
    }
}

TEST(RotaryPrograms, KeepFullRotations)
{
    const PartOnMachine setup = part_on("caB");
    const ToolPath path = path_of("G1 C-700 F100\nG91 C-30\nG90 A-0\n", setup);
    EXPECT_NEAR(path.machine->positions[1].rotary[0], test::rad(-700), 1e-12);
    EXPECT_NEAR(path.machine->positions[2].rotary[0], test::rad(-730), 1e-12);
    EXPECT_EQ(path.interpolation(), Interpolation::Joint);
}

// The chords of an arc share the turn evenly.
TEST(RotaryPrograms, TurnEvenlyAlongAnArc)
{
    const PartOnMachine setup = part_on("Bca");
    const ToolPath path =
        path_of("G1 X10 F100\nG3 X-10 I-10 C90\n", setup, Interpolation::Tcp);
    const auto& positions = path.machine->positions;
    const std::size_t count = positions.size() - 2;
    ASSERT_GT(count, 10U);
    for (std::size_t i = 1; i < positions.size(); ++i)
        EXPECT_NEAR(positions[i].rotary[0],
                    test::rad(90) * static_cast<double>(i - 1) / count, 1e-12);
    EXPECT_NEAR(path.points.back().location.tip.x(), -10, 1e-12);
}

TEST(RotaryPrograms, KnowPlungesAlongATiltedAxis)
{
    const PartOnMachine setup = part_on("Bca");
    const ToolPath path =
        path_of("G0 A30\nG1 Y5 Z-8.660254 F100\nG1 X3\nG1 Y0 Z0\nG1 A0\n", setup,
                Interpolation::Tcp);
    const auto& points = path.points;
    ASSERT_EQ(points.size(), 6U);
    EXPECT_EQ(points[2].move, Move::Plunge);
    EXPECT_EQ(points[3].move, Move::Cut);
    EXPECT_EQ(points[4].move, Move::Retract);
    EXPECT_EQ(points[5].move, Move::Cut);
}

TEST(RotaryPrograms, StateAnAssumedPosition)
{
    const Program program = parse_gcode("G21 G90\nG0 X0 Y0 Z0 A5\nG1 X1 F9\nM2\n",
                                        "f.ngc", reading_of(part_on("caB")));
    EXPECT_THAT(program.remarks,
                Contains(HasSubstr("no position of C before the path begins")));
}

TEST(RotaryPrograms, RefuseTurnsThatNoMoveMakes)
{
    const auto complaint = [](const std::string& lines) {
        try {
            path_of(lines, part_on("caB"));
        } catch (const FormatError& error) {
            return error.code() + ' ' + error.what();
        }
        return std::string{"accepted"};
    };
    EXPECT_THAT(complaint("G81 X1 Z-1 R1 A5 F9\n"),
                HasSubstr("f.ngc:4: a rotary word beside a canned cycle"));
    EXPECT_THAT(complaint("G28 A0\n"),
                HasSubstr("f.ngc:4: a rotary word beside G28, G30 or G53"));
    EXPECT_THAT(complaint("G1 A5\n"), HasSubstr("a move at feed before any F"));
    EXPECT_THAT(complaint("G93\nG1 A5\n"), HasSubstr("no F in a block under G93"));
}

// Check [8] by canonical output: the rates that rs274 prints give the same times.
TEST(RotaryPrograms, OfCanonicalOutputAreTheSame)
{
    const PartOnMachine setup = part_on("caB");
    const std::string text =
        "1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)\n"
        "2 N..... STRAIGHT_TRAVERSE(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
        "3 N..... SET_FEED_RATE(150.0000)\n"
        "4 N..... STRAIGHT_FEED(0.0000, 5.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
        "5 N..... SET_FEED_RATE(3801.3156)\n"
        "6 N..... STRAIGHT_FEED(0.0000, 5.0000, 0.0000, 10.0000, 0.0000, 380.0000)\n"
        "7 N..... PROGRAM_END()\n";
    GcodeReadOptions options = reading_of(setup, Interpolation::Tcp);
    options.rotary->cutter_radius = 10;
    const Program program = parse_canonical(text, "f.txt", options);
    const ToolPath& path = program.path;
    // Four decimals: 5e-5 mm, and 5e-5 degrees of two angles at 5 mm from the axes.
    EXPECT_NEAR(program.position_error_mm, 5e-5 + 2 * 5 * test::rad(5e-5), 1e-12);
    ASSERT_EQ(path.points.size(), 3U);
    EXPECT_NEAR(path.points[1].conditions.feed_mm_per_min.value_or(0), 150, 1e-9);
    EXPECT_NEAR(path.points[2].conditions.feed_mm_per_min.value_or(0),
                100 * test::rad(10), 1e-6);
    EXPECT_NEAR(path.machine->positions[2].rotary[0], test::rad(380), 1e-12);
    const std::string wrong =
        "1 N..... STRAIGHT_TRAVERSE(0.0, 0.0, 0.0, 0.0, 5.0, 0.0)\n";
    EXPECT_THROW(parse_canonical(wrong, "f.txt", options), FormatError);
}

}  // namespace
}  // namespace endmill
