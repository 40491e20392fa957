// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_interpreter.h"

#include <numbers>

#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

const std::string program =
    program_of("G1 X10 F100\n(no move)\nS500\nG3 X0 I-5 F200\nG0 Z5");

TEST(GcodeMoves, NameTheLinesThatMoveTheTool)
{
    const std::vector<GcodeMove> moves = gcode_moves(program, "f.ngc", {});
    ASSERT_EQ(moves.size(), 4U);
    EXPECT_EQ(moves[0].line, 2U);
    EXPECT_EQ(moves[1].line, 3U);
    EXPECT_EQ(moves[2].line, 6U);
    EXPECT_EQ(moves[3].line, 7U);
}

// The ranges of the moves follow each other and cover the path of the same program.
TEST(GcodeMoves, ShareThePointsOfThePathAmongThem)
{
    const std::vector<GcodeMove> moves = gcode_moves(program, "f.ngc", {});
    std::size_t next = 0;
    for (const GcodeMove& move : moves) {
        EXPECT_EQ(move.first, next);
        EXPECT_LT(move.first, move.end);
        next = move.end;
    }
    EXPECT_EQ(next, read_gcode(program).path.points.size());
}

TEST(GcodeMoves, KeepTheModesAndTheArcOfTheirLine)
{
    const std::vector<GcodeMove> moves = gcode_moves(program, "f.ngc", {});
    EXPECT_EQ(moves[1].modes.motion, GcodeMotion::Straight);
    EXPECT_FALSE(moves[1].arc);
    EXPECT_EQ(moves[2].modes.motion, GcodeMotion::CounterclockwiseArc);
    ASSERT_TRUE(moves[2].arc);
    EXPECT_EQ(moves[2].arc->centre, Vec3(5, 0, 0));
    EXPECT_NEAR(arc_angle(*moves[2].arc), std::numbers::pi, 1e-15);
    EXPECT_EQ(moves[3].modes.motion, GcodeMotion::Rapid);
}

// Points that were forgotten still count, also those of arcs and against the limit.
TEST(GcodeMoves, OneByOneAreThoseOfTheList)
{
    const std::vector<GcodeMove> moves = gcode_moves(program, "f.ngc", {});
    std::size_t number = 0;
    const std::size_t points =
        for_each_gcode_move(program, "f.ngc", {}, [&](const GcodeMove& move) {
            EXPECT_EQ(move.line, moves[number].line);
            EXPECT_EQ(move.end, moves[number++].end);
        });
    EXPECT_EQ(number, moves.size());
    EXPECT_EQ(points, read_gcode(program).path.points.size());
    const GcodeReadOptions few{.most_points = points - 1};
    EXPECT_THROW(for_each_gcode_move(program, "f.ngc", few, [](const GcodeMove&) {}),
                 LimitError);
}

}  // namespace
}  // namespace endmill
