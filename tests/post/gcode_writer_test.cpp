// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_writer.h"

#include <limits>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "path_conditions.h"
#include "random_path.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ToolPath path_of(const std::vector<std::pair<Move, Vec3>>& moves)
{
    ToolPath path;
    for (const auto& [move, tip] : moves)
        path.points.push_back(
            {0, static_cast<int>(path.points.size()), move, 0, {tip, Vec3::UnitZ()}});
    return path;
}

const ToolPath& small_path()
{
    static const ToolPath path = path_of({{Move::Plunge, {1, 2, -1}},
                                          {Move::Cut, {3.5, 2, -1}},
                                          {Move::Retract, {3.5, 2, 10}},
                                          {Move::Rapid, {0, 0.125, 10}},
                                          {Move::Plunge, {0, 0.125, -2}},
                                          {Move::Link, {1e-9, 4, -0.00001}}});
    return path;
}

TEST(Gcode, IsSafeAboveMovesAtFeedAndNotBelowItsRapids)
{
    const auto height = [](double rapid, double cut) {
        return gcode(path_of({{Move::Rapid, {0, 0, rapid}}, {Move::Cut, {9, 0, cut}}}),
                     {.feed_mm_per_min = 1})
            .safe_height_mm;
    };
    EXPECT_EQ(height(0, 0), default_clearance_mm);
    EXPECT_EQ(height(3, 0), default_clearance_mm);
    EXPECT_EQ(height(7, 0), 7);
    EXPECT_EQ(height(-9, -2), -2 + default_clearance_mm);
}

// Written by hand from docs/methods/removal.md, section 6, start and end of a
// program.
TEST(Gcode, WritesASmallPathAsByHand)
{
    const WrittenProgram program = gcode(small_path(), {.name = "plate",
                                                        .cutter = Cutter{6, 1},
                                                        .feed_mm_per_min = 800,
                                                        .spindle_rpm = 6000,
                                                        .tool = 4,
                                                        .tolerance = 0.02});
    EXPECT_EQ(program.text,
              "%\n"
              "(endmill: plate, cutter bull:12:1, tips)\n"
              "G21 G90 G94 G17 G40 G49 G80 G54\n"
              "G64 P0.01\n"
              "T4 M6\n"
              "S6000 M3\n"
              "G0 Z15.0000\n"
              "X1.0000 Y2.0000\n"
              "G1 Z-1.0000 F800\n"
              "X3.5000\n"
              "Z10.0000\n"
              "G0 X0.0000 Y0.1250\n"
              "G1 Z-2.0000\n"
              "Y4.0000 Z0.0000\n"
              "G0 Z15.0000\n"
              "M5\n"
              "M30\n"
              "%\n");
    EXPECT_EQ(program.lines, 18U);
    EXPECT_EQ(program.safe_height_mm, 15);
    EXPECT_DOUBLE_EQ(program.max_rounding_error_mm, 1e-5);
    EXPECT_EQ(program.feed_mm_per_min.least, 800);
    EXPECT_EQ(program.slanted_rapids + program.repeated_points, 0U);
}

TEST(Gcode, LeavesOutUnknownAndUnwantedWords)
{
    const std::string text =
        gcode(small_path(), {.feed_mm_per_min = 800, .decimals = 0, .comments = false})
            .text;
    EXPECT_TRUE(text.starts_with("%\nG21 G90 G94 G17 G40 G49 G80 G54\nG64\nT1 M6\nM3\n"));
    EXPECT_THAT(text, Not(HasSubstr("(")));
    EXPECT_THAT(text, Not(HasSubstr(".")));
}

TEST(Gcode, RisesNoFurtherWhereThePathIsAtTheSafeHeight)
{
    const ToolPath path = path_of({{Move::Rapid, {0, 0, 9}},
                                   {Move::Plunge, {0, 0, 1}},
                                   {Move::Retract, {0, 0, 9}}});
    const std::string text =
        gcode(path, {.feed_mm_per_min = 100, .safe_height = 9, .decimals = 1}).text;
    EXPECT_THAT(text, HasSubstr("M3\nG0 Z9.0\nX0.0 Y0.0\nG1 Z1.0 F100\nZ9.0\nM5\n"));
}

TEST(Gcode, HalvesTheToleranceWithDigitsEnough)
{
    const auto control = [](double tolerance, int decimals) {
        const std::string text =
            gcode(small_path(),
                  {.feed_mm_per_min = 1000, .tolerance = tolerance, .decimals = decimals})
                .text;
        const std::size_t begin = text.find("G80 G54\n") + 8;
        return text.substr(begin, text.find('\n', begin) - begin);
    };
    EXPECT_EQ(control(0.5, 4), "G64 P0.25");
    EXPECT_EQ(control(0.5 / 30, 4), "G64 P0.0083");
    EXPECT_EQ(control(0.5, 0), "G64 P0.25");
    EXPECT_EQ(control(0.0001, 4), "G64 P0.00005");
    EXPECT_EQ(control(1e-12, 4), "G61");
    EXPECT_EQ(control(0, 4), "G61");
}

TEST(Gcode, ChangesToolsAboveThePathAndComesBackToIt)
{
    ToolPath path = path_of({{Move::Plunge, {1, 2, 0}},
                             {Move::Cut, {5, 2, 0}},
                             {Move::Cut, {9, 2, 0}},
                             {Move::Retract, {9, 2, 4}},
                             {Move::Rapid, {0, 0, 4}}});
    path = test::with_conditions(
        path,
        {{100, 1000, 1}, {100, 1000, 1}, {200, 2000, 2}, {200, 2000, 2}, {{}, 2000, 3}});
    EXPECT_THAT(gcode(path, {.decimals = 0}).text,
                HasSubstr("T1 M6\nS1000 M3\nG0 Z9\nX1 Y2\nG1 Z0 F100\nX5\n"
                          "G0 Z9\nT2 M6\nS2000 M3\nG0 Z9\nX5 Y2\nG1 Z0 F200\nX9\nZ4\n"
                          "G0 Z9\nT3 M6\nM3\nG0 Z9\nX9 Y2\nX0 Y0 Z4\n"));
}

TEST(Gcode, CountsPointsThatRoundingMakesEqualAndRapidsThatSlant)
{
    const ToolPath path = path_of({{Move::Plunge, {0, 0, 0}},
                                   {Move::Cut, {0.00001, 0, 0}},
                                   {Move::Rapid, {0, 0, 0.00001}},
                                   {Move::Cut, {1, 0, 0}},
                                   {Move::Rapid, {1, 1, 1}}});
    const WrittenProgram program = gcode(path, {.feed_mm_per_min = 100});
    EXPECT_EQ(program.repeated_points, 2U);
    EXPECT_EQ(program.slanted_rapids, 1U);
}

// Text that a control refuses or misreads, whatever the numbers are.
TEST(Gcode, HasOnlyPlainWords)
{
    const std::regex word{"[NGXYZFSTMP]-?[0-9]+(\\.[0-9]+)?"};
    for (const double size : {1e-6, 1.0, 1e5}) {
        const ToolPath path = test::random_path(4, 300, -size, size);
        const std::string text =
            gcode(path, {.name = "x", .line_numbers = true, .comments = false}).text;
        for (std::string line; const char character : text) {
            if (character != '\n' && character != ' ') {
                line += character;
                continue;
            }
            EXPECT_TRUE(line == "%" || std::regex_match(line, word)) << line;
            line.clear();
        }
        EXPECT_THAT(text, Not(testing::ContainsRegex("[XYZ]-0\\.0*[ \n]")));
    }
}

TEST(Gcode, RefusesAnAxisThatIsNotUpright)
{
    ToolPath path = small_path();
    path.points[3].location.axis = {0, 0.6, 0.8};
    try {
        gcode(path, {.feed_mm_per_min = 100});
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("the axis at point 3 of the path is 0, 0.6, 0.8"));
    }
    for (PathPoint& point : path.points)
        point.location.axis = {0, 0, -1};
    EXPECT_THROW(gcode(path, {.feed_mm_per_min = 100}), GeometryError);
}

TEST(Gcode, RefusesArgumentsOutsideItsDomain)
{
    const auto refused = [](const ToolPath& path, GcodeOptions options) {
        options.feed_mm_per_min = 100;
        EXPECT_THROW(gcode(path, options), DomainError);
    };
    refused({}, {});
    refused(small_path(), {.tool = -1});
    refused(small_path(), {.safe_height = 9.99});
    refused(small_path(), {.safe_height = nan});
    refused(small_path(), {.tolerance = -1});
    refused(small_path(), {.tolerance = nan});
    refused(small_path(), {.decimals = 10});
    refused(small_path(), {.decimals = -1});
    EXPECT_THROW(gcode(small_path()), DomainError);  // without a feed
    ToolPath path = small_path();
    path.points[1].location.tip.y() = nan;
    refused(path, {});
    path.points[1].location.tip.y() = std::numeric_limits<double>::infinity();
    refused(path, {});
    path.points[1].location = {{0, 0, 0}, {0, 0, nan}};
    refused(path, {});
}

}  // namespace
}  // namespace endmill
