// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/rotary_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "five_axis.h"

namespace endmill {
namespace {

using testing::HasSubstr;

double unwrapped(RotaryWrap wrap, double word, double now)
{
    return unwrapped_word(wrap, word, std::signbit(word), now);
}

// Check [9] of docs/methods/five-axis-paths.md, section 9.
TEST(UnwrappedWord, FollowsTheRuleOfTheAxis)
{
    EXPECT_EQ(unwrapped(RotaryWrap::Unwrapped, 340, 20), 340);
    EXPECT_EQ(unwrapped(RotaryWrap::Shortest, 340, 20), -20);
    EXPECT_EQ(unwrapped(RotaryWrap::Signed, 340, 20), 340);
    EXPECT_EQ(unwrapped(RotaryWrap::Unwrapped, -340, 20), -340);
    EXPECT_EQ(unwrapped(RotaryWrap::Shortest, -340, 20), 20);
    EXPECT_EQ(unwrapped(RotaryWrap::Signed, -340, 20), -20);
}

TEST(UnwrappedWord, CountsFullRotations)
{
    EXPECT_EQ(unwrapped(RotaryWrap::Unwrapped, -700, 20), -700);
    EXPECT_EQ(unwrapped(RotaryWrap::Signed, 10, 735), 1090);  // on to the next rotation
    EXPECT_EQ(unwrapped(RotaryWrap::Signed, -10, 725), 370);  // back
    EXPECT_EQ(unwrapped(RotaryWrap::Signed, -0.0, 725), 720);
    EXPECT_EQ(unwrapped(RotaryWrap::Signed, -0.0, 720), 720);
    EXPECT_EQ(unwrapped(RotaryWrap::Shortest, 0, 180), 360);  // half a rotation: positive
    EXPECT_EQ(unwrapped(RotaryWrap::Shortest, 0, 725), 720);
}

std::optional<RotaryReading> reading_of(const std::string& word)
{
    RotaryReading reading;
    reading.setup = test::part_on(word);
    return reading;
}

std::string complaint(const std::string& line,
                      const std::optional<RotaryReading>& reading)
{
    TextLines lines{line, {"f", "E_GCODE"}};
    lines.next();
    try {
        RotaryWords{reading}.check(parse_block(line, lines), lines);
    } catch (const FormatError& error) {
        return error.code() + ' ' + error.what();
    }
    return "accepted";
}

TEST(RotaryWords, NeedTheMachine)
{
    EXPECT_EQ(
        complaint("G1 X1 A10", {}),
        "E_GCODE f:1: A10; expected A0, or the machine of the program (--machine and "
        "--frame)");
    EXPECT_EQ(complaint("G1 X1 A0", {}), "accepted");
    EXPECT_EQ(complaint("G1 X1 A10 C-400", reading_of("caB")), "accepted");
    EXPECT_EQ(complaint("G1 X1 B5", reading_of("caB")),
              "E_GCODE f:1: B5 on the machine W/caBxyz/T; expected words of A and C");
    EXPECT_EQ(complaint("G1 A2000000", reading_of("caB")),
              "E_RANGE f:1: A2e+06; expected at most a million degrees");
    std::optional<RotaryReading> wrapped = reading_of("caB");
    wrapped->wraps[0] = RotaryWrap::Signed;
    EXPECT_THAT(complaint("G1 C360", wrapped), HasSubstr("less than 360 degrees"));
    EXPECT_EQ(complaint("G1 A360", wrapped), "accepted");
}

TEST(RotaryWords, BecomePositionsWithTheSignOfTheMachine)
{
    std::optional<RotaryReading> reading = reading_of("caB");
    reading->setup.machine.word_signs = {-1, 1};
    RotaryWords words{reading};
    EXPECT_EQ(words.letters(), "A and C");
    EXPECT_EQ(words.unstated_letters(), "A and C");
    const std::string line = "G0 C90";
    TextLines lines{line, {"f", "E_GCODE"}};
    lines.next();
    const GcodeBlock block = parse_block(line, lines);
    EXPECT_TRUE(words.moves(block));
    words.apply(block, DistanceMode::Absolute);
    words.apply(block, DistanceMode::Incremental);
    EXPECT_DOUBLE_EQ(words.positions()[0], -test::rad(180));
    EXPECT_EQ(words.positions()[1], 0);
    EXPECT_EQ(words.unstated_letters(), "A");
    words.set('A', 30);
    EXPECT_DOUBLE_EQ(words.positions()[1], test::rad(30));
}

}  // namespace
}  // namespace endmill
