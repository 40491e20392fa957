// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/parsed_lines.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"
#include "endmill/post/detail/text_lines.h"
#include "read_program.h"

namespace endmill {
namespace {

void expect_same(const GcodeBlock& one, const GcodeBlock& other)
{
    EXPECT_TRUE(std::ranges::equal(one.g.all(), other.g.all()));
    EXPECT_TRUE(std::ranges::equal(one.m.all(), other.m.all()));
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        ASSERT_EQ(one.has(letter), other.has(letter)) << letter;
        if (one.has(letter) && letter != 'G' && letter != 'M') {
            EXPECT_EQ(one.value(letter), other.value(letter)) << letter;
        }
    }
}

// A line has the words that it has when it is parsed alone.
TEST(ParsedLines, HaveTheWordsOfEachLine)
{
    const std::string text =
        "N10 G90.1 G1 X-1.5 Y+.5 M8 M3\r\n\n  x1 2 (G2) y3\n(only this)\nF.5;G3\nG43.2";
    const ParsedLines parsed{text};
    TextLines lines{text, {"f", "E_GCODE"}};
    std::size_t count = 0;
    for (; lines.next(); ++count) {
        ASSERT_TRUE(parsed.is_parsed(count)) << count;
        expect_same(parsed.block(count), parse_block(lines.line(), lines));
    }
    EXPECT_EQ(parsed.size(), count);
}

TEST(ParsedLines, LeaveOutLinesThatDoNotBeginWithAWord)
{
    const ParsedLines parsed{"%\nO1001\n /X1\n:7\no2\nX1\n"};
    ASSERT_EQ(parsed.size(), 6U);
    for (std::size_t line = 0; line < 5; ++line)
        EXPECT_FALSE(parsed.is_parsed(line)) << line;
    EXPECT_TRUE(parsed.is_parsed(5));
}

TEST(ParsedLines, EndWithALineThatIsRefused)
{
    const ParsedLines parsed{"X1\nX1,5\nX2\n"};
    ASSERT_EQ(parsed.size(), 3U);
    EXPECT_TRUE(parsed.is_parsed(0));
    EXPECT_FALSE(parsed.is_parsed(1));
    EXPECT_FALSE(parsed.is_parsed(2));
}

TEST(LengthOfLines, IsThatOfWholeLines)
{
    EXPECT_EQ(length_of_lines("ab\ncd\n", 1), 3U);
    EXPECT_EQ(length_of_lines("ab\ncd\n", 3), 3U);
    EXPECT_EQ(length_of_lines("ab\ncd\n", 4), 6U);
    EXPECT_EQ(length_of_lines("ab\ncd", 4), 5U);
    EXPECT_EQ(length_of_lines("", 4), 0U);
}

// A program of many chunks, which several threads parse.
std::string long_program(std::size_t moves)
{
    std::string text = "G21 G90 G0 X0 Y0 Z5\nG1 Z0 F100\n";
    for (std::size_t i = 1; i <= moves; ++i)
        text += "G1 X" + std::to_string(i) + " Y1.25 Z-0.5 (move)\n";
    return text;
}

constexpr std::size_t many = 150'000;  // moves, 4 MB of text

TEST(ParsedLines, MakeThePathOfALongProgramForAnyNumberOfThreads)
{
    for (const int threads : {1, 2, 8}) {
        set_thread_count(threads);
        const Program program = read_gcode(long_program(many));
        const auto& points = program.path.points;
        ASSERT_EQ(points.size(), many + 2);
        for (std::size_t i = 1; i <= many; ++i)
            ASSERT_EQ(points[i + 1].location.tip,
                      Vec3(static_cast<double>(i), 1.25, -0.5));
    }
}

// The first fault in the order of the lines is reported, with its line.
TEST(ParsedLines, ReportTheFirstFaultOfALongProgram)
{
    for (const int threads : {1, 2, 8}) {
        set_thread_count(threads);
        const std::string text = long_program(many) + "G1 X1,5\n" + long_program(many) +
                                 "(unclosed\n" + long_program(many);
        const std::string message = refusal_of([&] { read_gcode(text); });
        EXPECT_NE(message.find(":" + std::to_string(many + 3) + ": decimal comma"),
                  std::string::npos)
            << message;
    }
}

TEST(ParsedLines, IgnoreFaultsAfterTheEndOfAProgram)
{
    const std::string text = long_program(many) + "M30\nX1,5\n(unclosed\n";
    EXPECT_EQ(read_gcode(text).path.points.size(), many + 2);
}

}  // namespace
}  // namespace endmill
