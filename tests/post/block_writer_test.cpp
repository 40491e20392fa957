// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/block_writer.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(BlockWriter, WritesWordsOnlyWhereTheyChange)
{
    BlockWriter blocks{{2, false}};
    blocks.add_move(Motion::Feed, {1, 2, 3}, 100);
    blocks.add_move(Motion::Feed, {1, 2, 4}, 100);
    blocks.add_move(Motion::Feed, {1, 3, 4}, 200);
    blocks.add_move(Motion::Rapid, {1.5, 3, 4}, {});
    blocks.set_speed(900);
    blocks.add_move(Motion::Feed, {1.5, 3, 5}, 200);
    blocks.add_move(Motion::Feed, {1.5, 3, 6}, 200);
    EXPECT_EQ(blocks.text(),
              "G1 X1.00 Y2.00 Z3.00 F100\nZ4.00\nY3.00 F200\nG0 X1.50\nG1 Z5.00 S900\n"
              "Z6.00\n");
    EXPECT_EQ(blocks.lines(), 6U);
}

// Numbers with the same text are the same number for the control.
TEST(BlockWriter, ComparesNumbersAsTheyAreSpelled)
{
    BlockWriter blocks{{1, true}};
    EXPECT_TRUE(blocks.add_move(Motion::Feed, {1.04, -0.01, 0}, 10.04));
    EXPECT_FALSE(blocks.add_move(Motion::Feed, {0.96, 0.01, 0.04}, 9.96));
    EXPECT_TRUE(blocks.add_move(Motion::Feed, {0.94, 0, 0}, 9.96));
    EXPECT_EQ(blocks.text(), "N1 G1 X1.0 Y0.0 Z0.0 F10\nN2 X0.9\n");
    EXPECT_NEAR(blocks.max_rounding_error_mm(), 0.04, 1e-15);
}

TEST(BlockWriter, WritesAllWordsAfterThePositionIsForgotten)
{
    BlockWriter blocks{{0, false}};
    blocks.add_move(Motion::Rapid, {1, 2, 3}, {});
    blocks.forget_position();
    blocks.add_rise(3);
    blocks.add_move(Motion::Rapid, {1, 2, 3}, {});
    EXPECT_EQ(blocks.text(), "G0 X1 Y2 Z3\nG0 Z3\nX1 Y2\n");
}

TEST(BlockWriter, StartsTheSpindleWithTheSpeedOnlyIfItChanges)
{
    BlockWriter blocks{{4, false}};
    blocks.start_spindle();
    blocks.set_speed(1500.5);
    blocks.start_spindle();
    blocks.start_spindle();
    EXPECT_EQ(blocks.text(), "M3\nS1500.5 M3\nM3\n");
}

TEST(BlockWriter, NumbersBlocksInFiveDigitsAndNotOtherLines)
{
    BlockWriter blocks{{0, true}};
    blocks.add_line("%");
    for (int k = 0; k < 100000; ++k)
        blocks.add_block("M5");
    EXPECT_TRUE(blocks.text().starts_with("%\nN1 M5\nN2 M5\n"));
    EXPECT_TRUE(blocks.text().ends_with("N99998 M5\nN99999 M5\nN1 M5\n"));
    EXPECT_EQ(blocks.lines(), 100001U);
}

}  // namespace
}  // namespace endmill
