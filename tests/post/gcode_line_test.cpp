// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_line.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(GcodeLine, KeepsOtherWordsAndBlanks)
{
    for (const char* text :
         {"", "%", "N10 G1 X1.5 Y-2 (F1 is no word) F300 ; S5\r", "g1x1f 3 0 0",
          "/ G0 Z5", "(unclosed", "G1 X 1 . 5\tY2 ", "\xc3\xa4 (\xc3\xa4)"})
        EXPECT_EQ(GcodeLine{text}.text(), text);
}

TEST(GcodeLine, FindsItsWords)
{
    const GcodeLine line{"n7 g1 X1 (S9) f 3 0.5 ;M3"};
    EXPECT_TRUE(line.has('N'));
    EXPECT_TRUE(line.has('F'));
    EXPECT_FALSE(line.has('S'));
    EXPECT_FALSE(line.has('M'));
    EXPECT_EQ(line.number('F'), 30.5);
    EXPECT_EQ(line.number('S'), std::nullopt);
    EXPECT_EQ(GcodeLine{"F#3"}.number('F'), std::nullopt);
}

std::string with(const char* text, char letter, const char* number)
{
    GcodeLine line{text};
    line.set(letter, number);
    return line.text();
}

TEST(GcodeLine, SetsAWordInItsPlaceOrBehindTheLast)
{
    EXPECT_EQ(with("G1 X1 f 3 00 Y2 (c)", 'F', "12.5"), "G1 X1 F12.5 Y2 (c)");
    EXPECT_EQ(with("G1 X1  (c)\r", 'F', "12.5"), "G1 X1 F12.5  (c)\r");
    EXPECT_EQ(with("\r", 'G', "2"), "G2\r");
    EXPECT_EQ(with("(c)", 'G', "2"), "G2(c)");
    EXPECT_EQ(with("X1;F", 'F', "2"), "X1 F2;F");
}

TEST(GcodeLine, RemovesWordsWithTheirBlanks)
{
    GcodeLine line{"G3 X1 Y2 I3J4 F5 (X)"};
    line.remove("XYIJF");
    EXPECT_EQ(line.text(), "G3 (X)");
    line.remove("G");
    EXPECT_EQ(line.text(), " (X)");
}

}  // namespace
}  // namespace endmill
