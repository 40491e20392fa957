// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/control.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(Control, KnowsWords)
{
    for (const char* words : {"M6", "G90 G94 G17", "G64 P0.5", "Z-5.", "G5.1 Q1"})
        EXPECT_TRUE(is_words(words)) << words;
    for (const char* text :
         {"",      " ",    "G",       "6",   "g90",  "G90  G17", "G90 ",
          " G90",  "G9-0", "G1.2.3",  "G+1", "G1e3", "G.5",      "G90;",
          "(G90)", "%",    "G90\nM6", "#1",  "[1]",  "G90\tG17", "O100 SUB"})
        EXPECT_FALSE(is_words(text)) << text;
    EXPECT_TRUE(is_word("M6", 'M'));
    EXPECT_FALSE(is_word("M6", 'G'));
    EXPECT_FALSE(is_word("M6 M7", 'M'));
    EXPECT_FALSE(is_word("", 'M'));
}

TEST(Control, LetsStartBlocksOnlySetModes)
{
    EXPECT_FALSE(unfit_start_word("G90 G94 G17 G40 G49 G80 G54 G61.1 G64 P0.1"));
    for (const char* block :
         {"G5.1 Q1", "G54.1 P12", "Q0.5 P0.25 G64", "G187 P3", "M48 G090 G8 G15",
          "G49 G50 G50.1 G59.3 G61 G67 G69 G80 G91.1 G97 G98 G017"})
        EXPECT_FALSE(unfit_start_word(block)) << block;
    for (const char* word :
         {"X0",  "Z5",  "F100", "S100", "T1",  "N1",  "G0",  "G00", "G1", "G02",
          "G20", "G21", "G28",  "G53",  "G81", "G91", "G92", "G93", "M2", "M3",
          "M06", "M30", "H1",   "G18",  "G41", "G43", "G95", "G96", "P1", "Q1"})
        EXPECT_EQ(unfit_start_word(std::string{"G90 "} + word + " G17"), word);
}

// Controls read these as codes that move, call or turn.
TEST(Control, KnowsStartCodesByNumberAndNotBySpelling)
{
    for (const char* word :
         {"G91.",  "G90.", "G90.10", "G90.1",  "G1.",     "G65",
          "G65.0", "G10",  "G-90",   "G90.0.", "G099999", "G900000000000000",
          "M97",   "M101", "M198",   "M3",     "M03",     "M3.0",
          "M6",    "M30",  "M48.5",  "P1",     "Q1"})
        EXPECT_EQ(unfit_start_word(std::string{"G17 "} + word), word);
    EXPECT_EQ(unfit_start_word("G64 P-1"), "P-1");
    EXPECT_FALSE(unfit_start_word("G90.0"));
}

TEST(Control, KnowsWordsThatNeitherStopNorTurn)
{
    for (const char* word : {"M6", "M06", "M7", "M8", "M9", "M09", "M50", "M88", "M120"})
        EXPECT_TRUE(is_auxiliary_word(word)) << word;
    for (const char* word :
         {"M0",   "M00",  "M1",  "M2",   "M02", "M3",   "M003", "M4",
          "M5",   "M30",  "M60", "M97",  "M98", "M099", "M198", "M3.",
          "M3.0", "M6.1", "M-6", "M199", "G6",  "M",    "",     "M6 M3"})
        EXPECT_FALSE(is_auxiliary_word(word)) << word;
    EXPECT_TRUE(is_tool_length_word("G43"));
    EXPECT_TRUE(is_tool_length_word("G043"));
    for (const char* word : {"G43.1", "G43.", "G44", "G0", "M43", "G43 G0", ""})
        EXPECT_FALSE(is_tool_length_word(word)) << word;
}

TEST(Control, IsSoundByDefaultAndRefusedOtherwise)
{
    EXPECT_NO_THROW(require_sound(Control{}));
    const auto refused = [](auto change) {
        Control control;
        change(control);
        EXPECT_THROW(require_sound(control), DomainError);
    };
    refused([](Control& control) { control.start = {"G90", "G0 Z5"}; });
    refused([](Control& control) { control.start = {"(G90)"}; });
    refused([](Control& control) { control.end = {"M30\nG0 Z-9"}; });
    refused([](Control& control) { control.tool_change = "M6 G0"; });
    refused([](Control& control) { control.tool_length = "M6"; });
    refused([](Control& control) { control.flood = ""; });
    refused([](Control& control) { control.coolant_off = "G9"; });
    refused([](Control& control) { control.decimals_mm = 10; });
    refused([](Control& control) { control.decimals_inch = -1; });
    refused([](Control& control) { control.speed_decimals = 10; });
    refused([](Control& control) { control.largest_line_number = 0; });
    refused([](Control& control) { control.program_number = 0; });
    refused([](Control& control) { control.tool_change = "M3"; });
    refused([](Control& control) { control.tool_length = "G0"; });
    refused([](Control& control) { control.coolant_off = "M30"; });
    refused([](Control& control) { control.largest_line_number = 100'000'000; });
    refused([](Control& control) { control.program_number = 100'000'000; });
    refused([](Control& control) { control.longest_line = 39; });
    refused([](Control& control) { control.longest_line = 1'000'001; });
}

TEST(Control, EndsItsPrograms)
{
    for (const char* words : {"M30", "M2", "M02", "M5 M30", "M2 M9"})
        EXPECT_TRUE(ends_program(words)) << words;
    for (const char* words : {"M5", "M20", "M3", "G30", "M2.1", "G91 G28 Z0"})
        EXPECT_FALSE(ends_program(words)) << words;
    EXPECT_THROW(require_sound({.end = {}}), DomainError);
    EXPECT_THROW(require_sound({.end = {"M5"}}), DomainError);
}

}  // namespace
}  // namespace endmill
