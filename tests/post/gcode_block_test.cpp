// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_block.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;

GcodeBlock block_of(const std::string& text)
{
    TextLines lines{text, {"f", "E_GCODE"}};
    lines.next();
    return parse_block(lines.line(), lines);
}

std::string refusal(const std::string& text)
{
    return refusal_of([&] { block_of(text); });
}

TEST(ParseBlock, ReadsLettersAndNumbers)
{
    const GcodeBlock block = block_of("N10 G1 X-1.5 Y+.5 Z5. F800\r");
    EXPECT_THAT(block.g.all(), ElementsAre(10));
    EXPECT_THAT(block.m.all(), ElementsAre());
    EXPECT_EQ(block.value('N'), 10);
    EXPECT_EQ(block.value('X'), -1.5);
    EXPECT_EQ(block.value('Y'), 0.5);
    EXPECT_EQ(block.value('Z'), 5);
    EXPECT_EQ(block.value('F'), 800);
    EXPECT_FALSE(block.has('I'));
    EXPECT_TRUE(block.has_any("IZ"));
    EXPECT_FALSE(block.has_any("IJ"));
}

// "G0X +0. 12 34Y 7" is the example of [KramerProctorMessina].
TEST(ParseBlock, IgnoresBlanksAndCase)
{
    const GcodeBlock block = block_of("g0x +0. 12 34y\t7 z- 1");
    EXPECT_THAT(block.g.all(), ElementsAre(0));
    EXPECT_EQ(block.value('X'), 0.1234);
    EXPECT_EQ(block.value('Y'), 7);
    EXPECT_EQ(block.value('Z'), -1);
    EXPECT_EQ(block_of("G1X1Y2").value('X'), 1);
}

TEST(ParseBlock, ReadsManyCodesWithTenths)
{
    const GcodeBlock block = block_of("G90.1 G59.3 G00 G043 M03 M8");
    EXPECT_THAT(block.g.all(), ElementsAre(901, 593, 0, 430));
    EXPECT_THAT(block.m.all(), ElementsAre(3, 8));
}

TEST(ParseBlock, LeavesCommentsOut)
{
    const GcodeBlock block = block_of("(G1 # [) X1 (a;b) Y2 ; (open, Z3");
    EXPECT_EQ(block.value('X'), 1);
    EXPECT_EQ(block.value('Y'), 2);
    EXPECT_FALSE(block.has('Z'));
    EXPECT_TRUE(block_of("()").is_empty());
    EXPECT_TRUE(block_of(" ( ) ").is_empty());
}

TEST(ParseBlock, ReadsLongNumbersToTheNearestDouble)
{
    EXPECT_EQ(block_of("X0.1000000000000000055511151231257827").value('X'), 0.1);
    EXPECT_EQ(block_of("X" + std::string(300, '0') + "7").value('X'), 7);
}

TEST(ParseBlock, AdvisesToExpandParametersAndSubprograms)
{
    const std::string expand =
        "; expected plain numbers: --interpreter linuxcnc expands them";
    EXPECT_EQ(refusal("#1=5"), "E_GCODE f:1: parameter \"#1=5\"" + expand);
    EXPECT_EQ(refusal("G1 X#1"), "E_GCODE f:1: parameter \"#1\"" + expand);
    EXPECT_EQ(refusal("X[1+2]"), "E_GCODE f:1: expression \"[1+2]\"" + expand);
    for (const std::string word : {"O100 sub", "o<a> call", "O0001"})
        EXPECT_EQ(refusal(word),
                  "E_GCODE f:1: O-word \"" + word +
                      "\"; expected moves alone: --interpreter linuxcnc expands "
                      "subroutines");
}

TEST(ParseBlock, RefusesNumbersOtherThanPlainDecimals)
{
    EXPECT_EQ(refusal("X1E5"),
              "E_GCODE f:1: exponent \"E5\"; expected a plain decimal number without "
              "exponent");
    EXPECT_EQ(refusal("X1.e-5 Y2"),
              "E_GCODE f:1: exponent \"e-5 Y2\"; expected a plain decimal number without "
              "exponent");
    EXPECT_EQ(refusal("X1,5"),
              "E_GCODE f:1: decimal comma \",5\"; expected \".\" as decimal sign");
    for (const std::string number : {"", "nan", "NAN", "inf", "-", "+", ".", "--1", "Y1"})
        EXPECT_EQ(refusal("Z1 X" + number),
                  number == "." ? "E_GCODE f:1: \"X.\"; expected a number with one point"
                                : "E_GCODE f:1: \"X\" without a number; expected a plain "
                                  "decimal number after the letter");
    EXPECT_EQ(refusal("X1.2.3"),
              "E_GCODE f:1: \"X1.2.3\"; expected a number with one point");
    EXPECT_EQ(refusal("X1-2"),
              "E_GCODE f:1: \"-2\"; expected a word: a letter and a number");
    EXPECT_EQ(refusal("X1" + std::string(400, '0')),
              "E_RANGE f:1: \"X1" + std::string(38, '0') +
                  "...\"; expected a number that a double can store");
}

TEST(ParseBlock, RefusesUnknownWords)
{
    const std::string known = "; expected words of ABCDFGHIJKLMNPQRSTXYZ";
    EXPECT_EQ(refusal("G0 U1"), "E_GCODE f:1: unknown word \"U1\"" + known);
    EXPECT_EQ(refusal("G1 X1 E5"), "E_GCODE f:1: unknown word \"E5\"" + known);
    EXPECT_EQ(refusal("\x1bX"),
              "E_GCODE f:1: a hidden character in \"\\x1bX\"; expected words of letters "
              "and numbers");
    EXPECT_EQ(
        refusal("G0 X\xc2\xa0"
                "5"),
        "E_GCODE f:1: a hidden character in \"X\\u00a05\"; expected words of letters "
        "and numbers");
    EXPECT_EQ(refusal("G0 @5"),
              "E_GCODE f:1: polar coordinates \"@5\"; expected X and Y: --interpreter "
              "linuxcnc expands them");
    EXPECT_EQ(refusal("TRAORI"),
              "E_GCODE f:1: tool-centre-point code \"TRAORI\"; expected positions of "
              "the axes, or tips with rotary words (--frame part)");
    for (const char* call : {"TCPM F100", "FUNCTION TCPM F TCP", "12 Function TCPM"})
        EXPECT_EQ(refusal(call),
                  "E_GCODE f:1: tool-centre-point code \"TCPM\"; expected positions of "
                  "the axes, or tips with rotary words (--frame part)");
}

TEST(ParseBlock, RefusesAWordTwice)
{
    EXPECT_EQ(refusal("X1 X1"),
              "E_GCODE f:1: word X twice in a block; expected the word once");
    EXPECT_EQ(
        refusal("G1 G01"),
        "E_GCODE f:1: G1 twice in a block, or with too many other codes; expected one "
        "code of each modal group");
    std::string many;
    for (int code = 100; code < 121; ++code)
        many += "M" + std::to_string(code);
    EXPECT_EQ(
        refusal(many),
        "E_GCODE f:1: M120 twice in a block, or with too many other codes; expected "
        "one code of each modal group");
}

TEST(ParseBlock, RefusesUnknownCodes)
{
    EXPECT_EQ(refusal("G1.05"),
              "E_GCODE f:1: unknown code G1.05; expected " + std::string{known_g_codes});
    EXPECT_EQ(refusal("G-1"),
              "E_GCODE f:1: unknown code G-1; expected " + std::string{known_g_codes});
    EXPECT_EQ(refusal("M3.5"), "E_GCODE f:1: unknown code M3.5; expected M0 to M999");
    EXPECT_EQ(refusal("M1000000000000"),
              "E_GCODE f:1: unknown code M1e+12; expected M0 to M999");
}

TEST(ParseBlock, RefusesCommentsThatDoNotEnd)
{
    EXPECT_EQ(refusal("X1 (start"),
              "E_GCODE f:1: unclosed comment \"(start\"; expected a )");
    EXPECT_EQ(refusal("(a (b) X1"),
              "E_GCODE f:1: comment in a comment \"(a (b) X1\"; expected a ) before the "
              "next (");
    EXPECT_EQ(refusal("X1 )"), "E_GCODE f:1: \")\"; expected a ( before the )");
}

}  // namespace
}  // namespace endmill
