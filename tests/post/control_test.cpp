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
    EXPECT_FALSE(unfit_start_word("G5.1 Q1"));
    for (const char* word : {"X0",  "Z5",  "F100", "S100", "T1",  "N1",  "G0",  "G00",
                             "G1",  "G02", "G20",  "G21",  "G28", "G53", "G81", "G91",
                             "G92", "G93", "M2",   "M3",   "M06", "M30", "H1"})
        EXPECT_EQ(unfit_start_word(std::string{"G90 "} + word + " G17"), word);
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
}

TEST(Control, HasUnitsOfLength)
{
    EXPECT_EQ(millimetres_per(ProgramUnit::Mm), 1);
    EXPECT_EQ(millimetres_per(ProgramUnit::Inch), 25.4);
}

}  // namespace
}  // namespace endmill
