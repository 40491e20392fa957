// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/block_writer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

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

TEST(BlockWriter, KnowsEachAxisByItself)
{
    BlockWriter blocks{{1, false}};
    blocks.add_level_rapid({1, 2, 3});
    EXPECT_TRUE(std::isnan(blocks.tip().z()));
    blocks.add_rise(9);
    EXPECT_EQ(blocks.tip(), Vec3(1, 2, 9));
    blocks.add_level_rapid({1, 2, 3});
    EXPECT_EQ(blocks.text(), "G0 X1.0 Y2.0\nZ9.0\nX1.0 Y2.0\n");
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

// A quarter circle of radius 10 in each plane; signs and order of the words by
// [KramerProctorMessina, section 3.5.3].
TEST(BlockWriter, WritesArcsWithThePlaneOnlyWhereItChanges)
{
    BlockWriter blocks{{.decimals = 0}};
    blocks.add_move(Motion::Feed, {0, 0, 0}, 100);
    blocks.add_arc({{0, 0, 0}, {10, 10, 0}, {0, 10, 0}, ArcPlane::Xy, false}, {}, 100);
    blocks.add_arc({{10, 10, 0}, {20, 20, 0}, {20, 10, 0}, ArcPlane::Xy, true}, {}, 100);
    blocks.add_arc({{20, 20, 0}, {30, 20, 10}, {20, 20, 10}, ArcPlane::Zx, true}, {}, 50);
    blocks.add_arc({{30, 20, 10}, {30, 30, 20}, {30, 20, 20}, ArcPlane::Yz, false}, 10,
                   50);
    blocks.add_move(Motion::Feed, {0, 0, 0}, 50);
    EXPECT_EQ(blocks.text(),
              "G1 X0 Y0 Z0 F100\n"
              "G17 G3 X10 Y10 I0 J10\n"
              "G2 X20 Y20 I10 J0\n"
              "G18 X30 Z10 I0 K10 F50\n"
              "G19 G3 Y30 Z20 R10\n"
              "G1 X0 Y0 Z0\n");
    EXPECT_EQ(blocks.max_rounding_error_mm(), 0);
}

// 1 inch is 25.4 mm.
TEST(BlockWriter, WritesLengthsAndFeedsInInches)
{
    BlockWriter blocks{{.decimals = 3, .unit_mm = 25.4}};
    blocks.add_move(Motion::Feed, {25.4, -50.8, 0.0254}, 254);
    blocks.add_move(Motion::Feed, {25.4, -50.8, 0.0381}, 254);
    EXPECT_EQ(blocks.text(), "G1 X1.000 Y-2.000 Z0.001 F10\nZ0.002\n");
    EXPECT_NEAR(blocks.max_rounding_error_mm(), 0.0127, 1e-12);
    EXPECT_NEAR(blocks.tip().z(), 0.0508, 1e-15);
}

TEST(BlockWriter, EndsNumbersInAPointForControlsThatWantOne)
{
    BlockWriter blocks{{.decimals = 0, .speed_decimals = 0, .always_point = true}};
    blocks.set_speed(1500.4);
    blocks.start_spindle();
    blocks.add_move(Motion::Feed, {1, 2, 3}, 100);
    EXPECT_EQ(blocks.text(), "S1500 M3\nG1 X1. Y2. Z3. F100.\n");
    BlockWriter digits{{.decimals = 2, .always_point = true}};
    digits.add_move(Motion::Feed, {1, 2, 3}, 100.25);
    EXPECT_EQ(digits.text(), "G1 X1.00 Y2.00 Z3.00 F100.25\n");
}

TEST(BlockWriter, EndsLinesAndNumbersAsTheControlWants)
{
    BlockWriter blocks{{.decimals = 0,
                        .line_numbers = true,
                        .line_end = "\r\n",
                        .largest_line_number = 2}};
    for (int k = 0; k < 3; ++k)
        blocks.add_block("M5");
    EXPECT_EQ(blocks.text(), "N1 M5\r\nN2 M5\r\nN1 M5\r\n");
}

TEST(BlockWriter, RefusesALineThatIsTooLong)
{
    BlockWriter blocks{{.decimals = 1, .longest_line = 17}};
    blocks.add_move(Motion::Feed, {1, 2, 3}, {});
    EXPECT_EQ(blocks.text(), "G1 X1.0 Y2.0 Z3.0\n");
    EXPECT_THROW(blocks.add_move(Motion::Feed, {10, 20, -30}, 1), DomainError);
}

}  // namespace
}  // namespace endmill
