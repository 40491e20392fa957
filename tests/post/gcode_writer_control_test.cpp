// SPDX-License-Identifier: GPL-3.0-or-later

// Programs for controls with other words and numbers than the plain one. The expected
// texts are written by hand from docs/methods/removal.md, section 6.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/gcode_writer.h"
#include "path_conditions.h"
#include "read_program.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using testing::Not;

ToolPath path_of(const std::vector<std::pair<Move, Vec3>>& moves)
{
    ToolPath path;
    for (const auto& [move, tip] : moves)
        path.points.push_back(
            {0, static_cast<int>(path.points.size()), move, 0, {tip, Vec3::UnitZ()}});
    return path;
}

// A plunge, a cut, a retract.
ToolPath one_cut()
{
    ToolPath path = path_of({{Move::Plunge, {1, 2, -1}},
                             {Move::Cut, {3.5, 2, -1}},
                             {Move::Retract, {3.5, 2, 10}}});
    set_feeds(path, {.cutting_mm_per_min = 800, .plunge_share = 1.0 / 3});
    return path;
}

Control with_length_and_dwell()
{
    return {.tool_length = "G43",
            .dwell = DwellUnit::Milliseconds,
            .decimals_mm = 3,
            .speed_decimals = 0,
            .always_point = true};
}

TEST(GcodeControl, WritesLengthDwellCoolantAndPointsByHand)
{
    Control control = with_length_and_dwell();
    control.program_number = 7;
    control.capital_comments = true;
    control.path_control = PathControl::None;
    const WrittenProgram program = gcode(one_cut(), {.name = "plate",
                                                     .cutter = Cutter{6, 1},
                                                     .spindle_rpm = 6000.4,
                                                     .tool = 4,
                                                     .control = control,
                                                     .coolant = Coolant::Flood,
                                                     .dwell_s = 1.5});
    EXPECT_EQ(program.text,
              "%\n"
              "O0007 (ENDMILL: PLATE, CUTTER BULL:12:1, TIPS)\n"
              "G21 G90 G94 G17 G40 G49 G80 G54\n"
              "T4 M6\n"
              "S6000 M3\n"
              "G4 P1500\n"
              "M8\n"
              "G0 G43 H4 Z15.000\n"
              "X1.000 Y2.000\n"
              "G1 Z-1.000 F266.667\n"
              "X3.500 F800.\n"
              "Z10.000\n"
              "G0 Z15.000\n"
              "M9\n"
              "M5\n"
              "M30\n"
              "%\n");
    EXPECT_EQ(program.feed_mm_per_min.least, 800);
    EXPECT_DOUBLE_EQ(*program.plunge_feed_mm_per_min.greatest, 800.0 / 3);
}

TEST(GcodeControl, LeavesOutWhatTheControlLacks)
{
    const Control bare{.percent = false,
                       .comments = CommentStyle::Semicolon,
                       .start = {"G90", "G94"},
                       .end = {"M2"},
                       .path_control = PathControl::Exact,
                       .tool_change = {}};
    EXPECT_EQ(gcode(one_cut(), {.name = "a", .decimals = 0, .control = bare}).text,
              ";endmill: a, tips\nG21 G90\nG94\nG61\nM3\nG0 Z15\nX1 Y2\nG1 Z-1 F267\n"
              "X4 F800\nZ10\nG0 Z15\nM2\n");
    const std::string crlf =
        gcode(one_cut(), {.control = {.comments = CommentStyle::None, .crlf = true}})
            .text;
    EXPECT_TRUE(crlf.starts_with("%\r\nG21 G90"));
    EXPECT_EQ(std::ranges::count(crlf, '\r'), std::ranges::count(crlf, '\n'));
}

TEST(GcodeControl, TurnsCoolantOffAndPutsTheLengthOnAtEachTool)
{
    ToolPath path = one_cut();
    path = test::with_conditions(path, {{90, 1000, 1}, {300, 1000, 1}, {300, 2000, 2}});
    const std::string text = gcode(path, {.decimals = 0,
                                          .control = with_length_and_dwell(),
                                          .coolant = Coolant::Mist,
                                          .dwell_s = 2,
                                          .feeds = {.plunge_share = 0.5}})
                                 .text;
    EXPECT_THAT(text, HasSubstr("T1 M6\nS1000 M3\nG4 P2000\nM7\nG0 G43 H1 Z15.\nX1. Y2.\n"
                                "G1 Z-1. F90.\nX4. F300.\n"
                                "G0 Z15.\nM9\nT2 M6\nS2000 M3\nG4 P2000\nM7\n"
                                "G0 G43 H2 Z15.\nX4. Y2.\nG1 Z-1. F150.\nZ10. F300.\n"
                                "G0 Z15.\nM9\nM5\n"));
}

// 25.4 mm are 1 inch: the lengths, the feed and the tolerance.
TEST(GcodeControl, WritesInches)
{
    const ToolPath path =
        path_of({{Move::Plunge, {25.4, 0, 0}}, {Move::Cut, {50.8, 12.7, 0}}});
    const WrittenProgram program = gcode(path, {.feed_mm_per_min = 508,
                                                .safe_height = 10,
                                                .tolerance = 0.0508,
                                                .comments = false,
                                                .unit = ProgramUnit::Inch});
    EXPECT_EQ(program.text,
              "%\nG20 G90 G94 G17 G40 G49 G80 G54\nG64 P0.001\nT1 M6\nM3\nG0 Z0.39370\n"
              "X1.00000 Y0.00000\nG1 Z0.00000 F20\nX2.00000 Y0.50000\nG0 Z0.39370\nM5\n"
              "M30\n%\n");
    EXPECT_LE(program.max_rounding_error_mm, 0.000127);
    const ToolPath read = parse_gcode(program.text, "f.ngc").path;
    ASSERT_EQ(read.points.size(), 4U);
    EXPECT_NEAR((read.points[2].location.tip - Vec3{50.8, 12.7, 0}).norm(), 0, 1e-12);
    EXPECT_NEAR(*read.points[2].conditions.feed_mm_per_min, 508, 1e-10);
}

// Two circles, in G17 and G18, joined by lines, with one change of feed.
ToolPath circles()
{
    ToolPath path = path_of({{Move::Plunge, {10, 0, 0}}});
    const auto add = [&](const Vec3& tip, double feed) {
        path.points.push_back({0,
                               static_cast<int>(path.points.size()),
                               Move::Cut,
                               0,
                               {tip, Vec3::UnitZ()},
                               {},
                               {feed, 5000, 1}});
    };
    path.points[0].conditions = {100, 5000, 1};
    for (int k = 1; k <= 300; ++k)
        add({10 * std::cos(0.02 * k), 10 * std::sin(0.02 * k), 0}, k <= 100 ? 400 : 600);
    add({30, -3, 0}, 600);
    for (int k = 1; k <= 100; ++k)
        add({30 + 8 * std::sin(0.02 * k), -3, 8 * std::cos(0.02 * k) - 8}, 600);
    return path;
}

double distance_to(const ToolPath& path, const Vec3& place)
{
    double least = HUGE_VAL;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const Vec3& from = path.points[k - 1].location.tip;
        const Vec3 along = path.points[k].location.tip - from;
        const double length = along.squaredNorm();
        const double part = length > 0 ? (place - from).dot(along) / length : 0;
        least =
            std::min(least, (from + std::clamp(part, 0.0, 1.0) * along - place).norm());
    }
    return least;
}

class GcodeArcs : public testing::TestWithParam<Control> {};

TEST_P(GcodeArcs, StayWithinTheirBoundOfThePath)
{
    const ToolPath path = circles();
    const WrittenProgram program =
        gcode(path, {.control = GetParam(), .arc_tolerance = 0.002});
    // A turn of 2 rad at 400 mm/min, of 4 rad at 600 mm/min in two arcs, and 2 rad.
    // Coarse decimals may end an arc early.
    EXPECT_GE(program.arcs, 4U);
    EXPECT_LE(program.arcs, GetParam().decimals_mm == 4 ? 4U : 6U);
    EXPECT_LE(program.max_arc_error_mm, 0.002);
    EXPECT_GT(program.max_arc_error_mm, 0.0004);
    EXPECT_LE(program.lines, 25U);
    const double chords = 1e-4;
    const ToolPath read =
        parse_gcode(program.text, "f.ngc", {.arc_tolerance_mm = chords}).path;
    const double bound = program.max_arc_error_mm + chords + 1e-9;
    ToolPath cut = read;  // without the way to the first point and from the last one
    cut.points.erase(cut.points.begin());
    cut.points.pop_back();
    for (const PathPoint& point : cut.points)
        EXPECT_LE(distance_to(path, point.location.tip), bound);
    for (const PathPoint& point : path.points)
        EXPECT_LE(distance_to(cut, point.location.tip), bound);
    for (const PathPoint& point : cut.points) {
        const bool is_first =
            point.location.tip.y() > 1e-3 && point.location.tip.x() > -4;
        if (is_first && point.move == Move::Cut) {
            EXPECT_EQ(point.conditions.feed_mm_per_min, 400);
        }
        EXPECT_EQ(point.conditions.spindle_rpm, 5000);
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, GcodeArcs,
                         testing::Values(Control{}, Control{.arcs = ArcForm::Radius},
                                         Control{.decimals_mm = 3}));

TEST(GcodeControl, RampsDownBeforeTheFirstCut)
{
    const WrittenProgram program = gcode(
        one_cut(),
        {.spindle_rpm = 1000, .comments = false, .ramp = Angle::radians(std::atan(4))});
    // From 15 down to -1 at a slope of 4: 4 mm, 2 forward and 2 back.
    EXPECT_THAT(program.text, HasSubstr("G0 Z15.0000\nX1.0000 Y2.0000\n"
                                        "G1 X3.0000 Z7.0000 F266.6667\nX1.0000 Z-1.0000\n"
                                        "X3.5000 F800\n"));
    EXPECT_EQ(program.ramps, 1U);
}

TEST(GcodeControl, CountsTheVerticalDescentAfterAToolChange)
{
    ToolPath path = one_cut();
    path = test::with_conditions(path, {{90, 1000, 1}, {300, 1000, 1}, {300, 2000, 2}});
    const WrittenProgram sloped = gcode(path, {.ramp = Angle::radians(0.5)});
    EXPECT_EQ(sloped.ramps, 1U);
    EXPECT_EQ(sloped.straight_descents, 1U);
    EXPECT_EQ(gcode(path).straight_descents, 0U);
}

// An O number of eight digits leaves 28 of 40 characters: a blank and ( ) take three.
TEST(GcodeControl, CutsTheCommentToTheLine)
{
    const std::string text =
        gcode(one_cut(), {.name = std::string(60, 'a'),
                          .control = {.program_number = 12345678, .longest_line = 40}})
            .text;
    const std::string comment = ("endmill: " + std::string(60, 'a')).substr(0, 28);
    EXPECT_THAT(text, HasSubstr("%\nO12345678 (" + comment + ")\nG21"));
}

TEST(GcodeControl, RefusesWhatTheControlCannotDo)
{
    const auto refusal = [](const GcodeOptions& options,
                            const ToolPath& path) -> std::string {
        try {
            gcode(path, options);
            return "accepted";
        } catch (const DomainError& error) {
            return error.what();
        }
    };
    Control bare{.name = "mill",
                 .tool_change = {},
                 .dwell = {},
                 .flood = {},
                 .mist = {},
                 .arcs = ArcForm::None};
    EXPECT_EQ(refusal({.control = bare}, one_cut()), "accepted");
    EXPECT_THAT(refusal({.control = bare, .dwell_s = 1}, one_cut()),
                HasSubstr("mill has no dwell"));
    EXPECT_THAT(refusal({.control = bare, .coolant = Coolant::Flood}, one_cut()),
                HasSubstr("mill has no flood coolant"));
    EXPECT_THAT(refusal({.control = bare, .coolant = Coolant::Mist}, one_cut()),
                HasSubstr("mill has no mist coolant"));
    EXPECT_THAT(refusal({.control = bare, .arc_tolerance = 0.1}, one_cut()),
                HasSubstr("mill has no arcs"));
    EXPECT_THAT(refusal({.arc_tolerance = 0}, one_cut()),
                HasSubstr("arc tolerance above 0"));
    EXPECT_THAT(refusal({.dwell_s = -1}, one_cut()), HasSubstr("dwell from 0"));
    EXPECT_THAT(refusal({.control = {.end = {"G0 Z"}}}, one_cut()),
                HasSubstr("control:"));
    ToolPath two = one_cut();
    two.points[0].conditions.tool = 1;
    two.points[1].conditions.tool = 2;
    EXPECT_THAT(refusal({.control = bare}, two),
                HasSubstr("from tool 1 to tool 2 at point 1"));
    EXPECT_THAT(refusal({.control = {.start = {"G90 G94 G17 G40 G49 G80 G54 G61 G69 G98"},
                                     .longest_line = 40}},
                        one_cut()),
                HasSubstr("expected at most 40 for this control"));
}

TEST(GcodeControl, MovesXAndYFirstWhereToolsAreChangedAtTheTop)
{
    Control control = with_length_and_dwell();
    control.first_axes = FirstAxes::Xy;
    ToolPath path = path_of(
        {{Move::Plunge, {1, 2, 0}}, {Move::Cut, {5, 2, 0}}, {Move::Cut, {9, 2, 0}}});
    path = test::with_conditions(path, {{100, 1, 1}, {100, 1, 1}, {100, 1, 2}});
    EXPECT_THAT(gcode(path, {.decimals = 0, .control = control}).text,
                HasSubstr("T1 M6\nS1 M3\nG0 X1. Y2.\nG43 H1 Z5.\nG1 Z0. F100.\nX5.\n"
                          "G0 Z5.\nT2 M6\nM3\nG0 X5. Y2.\nG43 H2 Z5.\nG1 Z0.\nX9.\n"));
}

// The new tool comes back to a cut like any other descent.
TEST(GcodeControl, ApproachesEveryCutOfEveryToolAtRapid)
{
    ToolPath path = path_of({{Move::Plunge, {1, 2, 0}},
                             {Move::Cut, {5, 2, 0}},
                             {Move::Cut, {9, 2, 0}},
                             {Move::Retract, {9, 2, 7}},
                             {Move::Plunge, {9, 2, -1}},
                             {Move::Cut, {9, 9, -1}}});
    path = test::with_conditions(
        path,
        {{50, 1, 1}, {100, 1, 1}, {100, 1, 2}, {100, 1, 2}, {50, 1, 3}, {100, 1, 3}});
    const WrittenProgram program =
        gcode(path, {.safe_height = 9, .decimals = 0, .approach_distance = 2});
    EXPECT_THAT(program.text,
                HasSubstr("G0 Z9\nX1 Y2\nZ2\nG1 Z0 F50\nX5 F100\n"
                          "G0 Z9\nT2 M6\nM3\nG0 Z9\nX5 Y2\nZ2\nG1 Z0\nX9\nZ7\n"
                          "G0 Z9\nT3 M6\nM3\nG0 Z9\nX9 Y2\nZ1\nG1 Z-1 F50\nY9 F100\n"
                          "G0 Z9\nM5\n"));
    EXPECT_EQ(program.slanted_rapids, 0U);
    // By hand: 2 mm down three times, 4 + 4 + 7 mm of cuts, 7 mm up.
    EXPECT_EQ(program.totals.plunge_mm, 6);
    EXPECT_EQ(program.totals.cut_mm, 15);
    EXPECT_EQ(program.totals.link_mm, 7);
    EXPECT_EQ(program.totals.rapid_mm, 7 + 9 + 7 + 2 + 8 + 10);
    EXPECT_EQ(program.totals.tools, (std::vector{1, 2, 3}));
}

TEST(GcodeControl, HasNoToolZeroWhereToolsHaveWords)
{
    const ToolPath path = test::with_conditions(
        path_of({{Move::Plunge, {0, 0, 0}}, {Move::Cut, {9, 0, 0}}}),
        {{100, 1, 3}, {100, 1, 0}});
    EXPECT_THAT(refusal_of([&] { gcode(path); }),
                HasSubstr("point 1 of the path has tool 0"));
    Control bare;
    bare.tool_change.reset();
    EXPECT_NO_THROW(gcode(one_cut(), {.tool = 0, .control = bare}));
}

// Points of slopes and rapid descents do not count.
TEST(GcodeControl, NamesThePointsOfTheGivenPath)
{
    const ToolPath path = test::with_conditions(
        path_of(
            {{Move::Plunge, {0, 0, 0}}, {Move::Cut, {9, 0, 0}}, {Move::Cut, {9, 9, 0}}}),
        {{100, 1, 1}, {100, 1, 1}, {100, 1, 2}});
    Control bare;
    bare.tool_change.reset();
    EXPECT_THAT(
        refusal_of([&] {
            gcode(path,
                  {.control = bare, .approach_distance = 1, .ramp = Angle::degrees(3)});
        }),
        HasSubstr("from tool 1 to tool 2 at point 2"));
}

}  // namespace
}  // namespace endmill
