// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_heading.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(ProgramHeading, BeginsAndEndsAProgram)
{
    GcodeOptions options{.name = "part", .coolant = Coolant::Flood};
    options.control.program_number = 7;
    BlockWriter blocks{block_format(options)};
    write_start(blocks, options, "G61", "axes");
    write_end(blocks, options);
    EXPECT_EQ(blocks.text(),
              "%\nO0007 (endmill: part, axes)\nG21 G90 G94 G17 G40 G49 G80 G54\nG61\nM9\n"
              "M5\nM30\n%\n");
}

// P has as many decimals as it needs to be within 1 %.
TEST(ProgramHeading, StatesTheRoundingOfCorners)
{
    GcodeOptions options{.decimals = 2};
    EXPECT_EQ(blending_block(options, 0.05), "G64 P0.05");
    EXPECT_EQ(blending_block(options, 0.00251), "G64 P0.0025");
    EXPECT_EQ(blending_block(options, 0), "G61");
    EXPECT_EQ(blending_block(options, 1e-12), "G61");
    options.unit = ProgramUnit::Inch;
    EXPECT_EQ(blending_block(options, 25.4), "G64 P1");
}

TEST(ProgramHeading, WaitsInTheUnitOfTheControl)
{
    GcodeOptions options{.dwell_s = 1.5};
    EXPECT_EQ(dwell(options), "G4 P1.5");
    options.control.dwell = DwellUnit::Milliseconds;
    EXPECT_EQ(dwell(options), "G4 P1500");
}

TEST(ProgramHeading, RefusesACoolantThatTheControlLacks)
{
    GcodeOptions options;
    EXPECT_FALSE(coolant_word(options));
    options.coolant = Coolant::Mist;
    EXPECT_EQ(coolant_word(options), "M7");
    options.control.mist.reset();
    EXPECT_THROW(coolant_word(options), DomainError);
}

}  // namespace
}  // namespace endmill
