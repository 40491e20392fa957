// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/machine_gcode.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "five_axis.h"

namespace endmill {
namespace {

using test::cone_path;
using test::direction;
using test::part_on;
using test::path_through;
using testing::HasSubstr;
using testing::Not;

WrittenMachineProgram program_of(const ToolPath& path, const PartOnMachine& setup,
                                 const MachinePathOptions& options = {},
                                 const GcodeOptions& format = {})
{
    return machine_gcode(machine_path(path, setup, options), format);
}

// The sum of 1/F over the blocks under G93.
double inverse_minutes(const std::string& text)
{
    double sum = 0;
    bool is_inverse = false;
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("G93"))
            is_inverse = true;
        else if (line.starts_with("G94"))
            is_inverse = false;
        const std::size_t at = line.find('F');
        if (is_inverse && at != std::string::npos)
            sum += 1 / std::stod(line.substr(at + 1));
    }
    return sum;
}

// The whole program of a short path, as a person would write it.
TEST(MachineGcode, HasTheStructureOfAProgram)
{
    const PartOnMachine setup = part_on("caB");
    const ToolPath path =
        path_through({{{10, 0, 0}, {0, 0, 1}}, {{20, 0, 0}, {0, 0, 1}}});
    const WrittenMachineProgram made =
        program_of(path, setup, {}, {.name = "ring", .spindle_rpm = 1000});
    EXPECT_EQ(made.program.text,
              "%\n(endmill: ring, axes of W/caBxyz/T, tool length 0 mm)\nG21 G90 G94 G17 "
              "G40 G49 G80 G54\nG61\nT1 M6\nS1000 M3\n"
              "G0 Z25.0000\nA0.00000 C0.00000\nX10.0000 Y0.0000\n"
              "G1 Z0.0000 F600\nX20.0000\nG0 Z25.0000\nM5\nM30\n%\n");
}

// Check [6]: 10 mm at 600 mm/min take 1/60 min; C by 90 degrees at 3600 degrees/min takes
// 1/40 min. With the tip on the line of C and a constant tilt C alone moves.
TEST(MachineGcode, WritesTheInverseOfTheTime)
{
    PartOnMachine setup = part_on("Bca");
    const ToolPath line = path_through({{{0, 0, 0}, direction(setup, 10, 0)},
                                        {{10, 0, 0}, direction(setup, 10.0001, 0)}});
    EXPECT_THAT(program_of(line, setup).program.text,
                HasSubstr("G93\nX10.0000 A10.00010 F60\n"));
    setup.machine.rates.rotary_rad_per_min[0] = test::rad(3600);
    MachinePath turn;
    turn.path = path_through(
        {{{0, 0, 0}, direction(setup, 30, 0)}, {{0, 0, 0}, direction(setup, 30, 90)}});
    turn.path.machine = MachineMotion{
        .interpolation = Interpolation::Tcp,
        .setup = setup,
        .positions = {axis_positions(setup, {0, test::rad(30)}, {0, 0, 0}),
                      axis_positions(setup, {test::rad(90), test::rad(30)}, {0, 0, 0})}};
    turn.minutes = {HUGE_VAL, 1.0 / 40};
    turn.rows = {0, 1};
    EXPECT_THAT(machine_gcode(turn, {}).program.text, HasSubstr("G93\nC90.00000 F40\n"));
}

// The times of all blocks add up to length / feed; F has six digits.
TEST(MachineGcode, TakesTheTimeOfThePath)
{
    for (const char* word : {"caB", "Bcb", "aBb"}) {
        PartOnMachine setup = part_on(word);
        setup.tool_length = 80;
        const ToolPath path = cone_path(30, 12, 48);
        const MachinePath moved = machine_path(path, setup);
        const double length = path_totals(path).cut_mm;
        EXPECT_NEAR(moved.report.time_min, length / 600, 1e-12 * length);
        const double written = inverse_minutes(machine_gcode(moved, {}).program.text);
        EXPECT_NEAR(written, length / 600, 1e-5 * length / 600) << word;
        EXPECT_GE(written, length / 600 * (1 - 1e-15));
    }
}

// X, Y and Z belong to the rounded angles, so that the tip is off by its own rounding alone.
TEST(MachineGcode, RoundsTheAnglesFirst)
{
    test::Random random{41};
    for (int k = 0; k < 40; ++k) {
        PartOnMachine setup = test::random_part_on_machine(random, true);
        setup.machine.word_signs = {1, -1};
        std::vector<CutterLocation> poses;
        for (int i = 0; i < 6; ++i)
            poses.push_back({test::random_vector(random, 40),
                             (direction(setup, 25, 10) + test::random_vector(random, 0.3))
                                 .normalized()});
        const MachinePath made = machine_path(path_through(poses), setup);
        for (const int digits : {4, 6}) {
            const WrittenMachineProgram written =
                machine_gcode(made, {.decimals = digits}, {.angle_decimals = digits});
            const double unit = std::pow(10, -digits);
            EXPECT_LE(written.rounding_tip_mm, std::sqrt(3) / 2 * unit * (1 + 1e-6));
            EXPECT_GT(written.rounding_tip_mm, 0.3 * unit);
            EXPECT_LE(written.rounding_axis, test::rad(unit));
        }
    }
}

TEST(MachineGcode, WritesWordsWithTheSignsOfTheMachine)
{
    PartOnMachine setup = part_on("Bca");
    setup.machine.word_signs = {-1, 1};
    const ToolPath path = path_through({{{0, 0, 0}, direction(setup, 30, 40)}});
    EXPECT_THAT(program_of(path, setup).program.text,
                HasSubstr("\nA30.00000 C-40.00000\n"));
}

// Moves with resting rotary axes between rapids have feeds per minute.
TEST(MachineGcode, WritesIndexedMovesWithFeedsPerMinute)
{
    const PartOnMachine setup = part_on("Bca");
    ToolPath path = path_through({{{0, 0, 0}, direction(setup, 30, 40)},
                                  {{10, 0, 0}, direction(setup, 30, 40)},
                                  {{10, 0, 50}, direction(setup, 30, 40)},
                                  {{10, 0, 50}, direction(setup, 20, 40)},
                                  {{20, 0, 0}, direction(setup, 20, 40)},
                                  {{20, 0, 5}, direction(setup, 25, 40)}});
    path.points[2].move = path.points[3].move = path.points[4].move = Move::Rapid;
    const std::string text = program_of(path, setup).program.text;
    EXPECT_THAT(text, HasSubstr("F600\nX10.0000\nG0 "));
    EXPECT_THAT(text, HasSubstr("G93\nG1 "));
    EXPECT_LT(text.find("F600"), text.find("G93"));
    EXPECT_LT(text.find("G93"), text.rfind("G94"));
    const std::string at_feed =
        program_of(path, setup, {.rapid_feed = 3000}).program.text;
    EXPECT_LT(at_feed.find("G93"), text.find("G93"));
}

// In the frame of the part X, Y and Z are tips.
TEST(MachineGcode, InThePartWritesTips)
{
    PartOnMachine setup = part_on("caB");
    setup.clamp = {0, 0, 100};
    const ToolPath path = cone_path(30, 20, 12);
    const std::string text =
        program_of(path, setup, {.frame = Interpolation::Tcp}).program.text;
    EXPECT_THAT(text, HasSubstr("\nG1 X30.0000 Z110.0000 F600\n"));
    EXPECT_THAT(text, HasSubstr("X25.9808 Y15.0000 "));
}

TEST(MachineGcode, RefusesWhatSuchProgramsLack)
{
    const PartOnMachine setup = part_on("caB");
    const ToolPath path = path_through({{{0, 0, 0}, {0, 0, 1}}, {{9, 0, 0}, {0, 0, 1}}});
    EXPECT_THROW(program_of(path, setup, {}, {.arc_tolerance = 0.1}), DomainError);
    EXPECT_THROW(program_of(path, setup, {}, {.safe_height = -1}), DomainError);
    ToolPath two = path;
    two.points[1].conditions.tool = 2;
    EXPECT_THROW(program_of(two, setup), DomainError);
    ToolPath no_feed = path;
    no_feed.points[1].conditions.feed_mm_per_min.reset();
    EXPECT_THROW(program_of(no_feed, setup), DomainError);
    MachinePath slow = machine_path(cone_path(30, 20, 12), setup);
    slow.minutes[3] = 1e12;
    try {
        machine_gcode(slow, {});
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(), HasSubstr("of the path: the move takes 1e+12 min"));
    }
}

TEST(MachineGcode, MayLetTheControlRoundCorners)
{
    const PartOnMachine setup = part_on("caB");
    const MachinePath made = machine_path(cone_path(30, 20, 12), setup);
    EXPECT_THAT(machine_gcode(made, {}).program.text, HasSubstr("\nG61\n"));
    EXPECT_THAT(machine_gcode(made, {}, {.blend = 0.01}).program.text,
                HasSubstr("\nG64 P0.01\n"));
}

}  // namespace
}  // namespace endmill
