// SPDX-License-Identifier: GPL-3.0-or-later

// Refusals of whole programs.
// gcode_modes_test.cpp tests codes, gcode_block_test.cpp words and gcode_arc_test.cpp
// arcs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/post/gcode_reader.h"
#include "read_program.h"

namespace endmill {
namespace {

using testing::StartsWith;

struct Refused {
    const char* blocks;  // blocks from line 3 on
    const char* message;
};

class RefusedProgram : public testing::TestWithParam<Refused> {};

TEST_P(RefusedProgram, IsNamedWithItsLine)
{
    EXPECT_EQ(gcode_refusal(program_of(GetParam().blocks)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Words, RefusedProgram,
    testing::Values(
        Refused{"G1 A5 F9",
                "E_GCODE f.ngc:3: rotary axis word A; expected a three-axis "
                "program: five axes need --machine"},
        Refused{"\nB5",
                "E_GCODE f.ngc:4: rotary axis word B; expected a three-axis "
                "program: five axes need --machine"},
        Refused{"G10 L2 P1 X0",
                "E_GCODE f.ngc:3: setting of offsets G10; expected coordinates in one "
                "coordinate system of the part"},
        Refused{"X1 L2",
                "E_GCODE f.ngc:3: word L; expected L only beside an M code that takes "
                "it"},
        Refused{"C0",
                "E_GCODE f.ngc:3: rotary axis word C; expected a three-axis "
                "program: five axes need --machine"},
        Refused{"G80\nX5",
                "E_GCODE f.ngc:4: axis word without a motion mode; expected G0, "
                "G1, G2 or G3 in this block or before"},
        Refused{"G1 X5 I5 F9",
                "E_GCODE f.ngc:3: word I without an arc; expected the word in a block "
                "with G2 or G3"},
        Refused{"R5",
                "E_GCODE f.ngc:3: word R without an arc; expected the word in a block "
                "with G2 or G3"},
        Refused{"G0 X1 P5",
                "E_GCODE f.ngc:3: word P without an arc; expected the word in a block "
                "with G2 or G3"},
        Refused{"G2 F9\nG64 X10 I5 P2",
                "E_GCODE f.ngc:4: word P for both an arc and G4 or "
                "G64; expected two separate blocks"},
        Refused{"G4",
                "E_GCODE f.ngc:3: G4 without P >= 0; expected P, the time to wait in "
                "s"},
        Refused{"G4 X5",
                "E_GCODE f.ngc:3: G4 without P >= 0; expected P, the time to wait "
                "in s"},
        Refused{"G4 P-1",
                "E_GCODE f.ngc:3: G4 without P >= 0; expected P, the time to "
                "wait in s"},
        Refused{"G1 Q5 F9", "E_GCODE f.ngc:3: word Q; expected Q only beside G64"},
        Refused{"S-5", "E_GCODE f.ngc:3: a spindle speed S-5; expected S >= 0"},
        Refused{"T-1", "E_GCODE f.ngc:3: a tool T-1; expected a whole number from 0"},
        Refused{"T1.5", "E_GCODE f.ngc:3: a tool T1.5; expected a whole number from 0"},
        Refused{"T4294967296",
                "E_GCODE f.ngc:3: a tool T4.29497e+09; expected a whole number from 0"},
        Refused{"X1 Y2 X3",
                "E_GCODE f.ngc:3: word X twice in a block; expected the word once"}));

const char* const no_f = "E_GCODE f.ngc:3: a move at feed before any F; expected F > 0";

INSTANTIATE_TEST_SUITE_P(
    Feeds, RefusedProgram,
    testing::Values(
        Refused{"G1 X5", no_f}, Refused{"G2 X10 I5", no_f}, Refused{"G3 X10 R5", no_f},
        Refused{"G1 X5 F0", "E_GCODE f.ngc:3: a move at feed F0; expected F > 0"},
        Refused{"F0\nG1 X5", "E_GCODE f.ngc:4: a move at feed F0; expected F > 0"},
        Refused{"F-5", "E_GCODE f.ngc:3: a feed F-5; expected F > 0"},
        Refused{"G93 G1 X5 F9\nX6",
                "E_GCODE f.ngc:4: no F in a block under G93; expected F > 0"},
        Refused{"F9\nG93 G1 X5",
                "E_GCODE f.ngc:4: no F in a block under G93; expected F > 0"},
        Refused{"G93 F9\nG94 G1 X5",
                "E_GCODE f.ngc:4: a move at feed before any F; expected F > 0"}));

const char* const too_far =
    "E_RANGE f.ngc:3: coordinate 1e+07 mm; expected at most 1e+06 mm (--max-extent)";
// All words are within the extent, but points of the circle around -0.9e6 are not.
const char* const on_the_way =
    "E_RANGE f.ngc:3: coordinate -1e+06 mm; expected at most 1e+06 mm (--max-extent)";

INSTANTIATE_TEST_SUITE_P(
    Sizes, RefusedProgram,
    testing::Values(Refused{"X10000000", too_far}, Refused{"G91 X10000000", too_far},
                    Refused{"G20 X100000",
                            "E_RANGE f.ngc:3: coordinate 2.54e+06 mm; expected at most "
                            "1e+06 mm (--max-extent)"},
                    Refused{"G91 X800000\nX800000",
                            "E_RANGE f.ngc:4: coordinate 1.6e+06 mm; expected "
                            "at most 1e+06 mm (--max-extent)"},
                    Refused{"G2 I-900000 F9", on_the_way}));

TEST(ParseGcode, RefusesEmptyFilesAndEndlessLines)
{
    EXPECT_EQ(gcode_refusal(" \n"),
              "E_EMPTY f.ngc: file is empty; expected a file with content");
    EXPECT_EQ(gcode_refusal("G21\n(" + std::string(1U << 20U, 'x') + ")\n"),
              "E_LIMIT f.ngc:2: line is longer than 1 MiB; expected lines of at most "
              "1048576 bytes");
}

TEST(ParseGcode, RefusesMorePointsThanThereIsRoomFor)
{
    EXPECT_EQ(gcode_refusal(program_of("X1\nX2\nX3"), {.most_points = 3}),
              "E_LIMIT f.ngc:5: more than 3 points (--max-memory)");
    EXPECT_THAT(gcode_refusal(program_of("G2 I5 P1000000000 F9")),
                StartsWith("E_LIMIT f.ngc:3: an arc of 1.57"));
    EXPECT_THAT(gcode_refusal(program_of("G2 I5 F9"), {.arc_tolerance_mm = 1e-300}),
                StartsWith("E_LIMIT f.ngc:3: an arc of "));
    EXPECT_THAT(gcode_refusal(program_of("G2 I5 P1" + std::string(300, '0') + " F9")),
                StartsWith("E_LIMIT f.ngc:3: an arc of "));
}

TEST(ParseGcode, ChecksWordsOfArcsFromAnUnknownStart)
{
    EXPECT_EQ(gcode_refusal("G21\nG2 X5 F9\nM2"),
              "E_GCODE f.ngc:2: an arc without centre or R; expected I, J, K or R");
    EXPECT_EQ(gcode_refusal("G21\nG2 X5 I5\nM2"),
              "E_GCODE f.ngc:2: a move at feed before any F; expected F > 0");
    EXPECT_EQ(gcode_refusal("G21 G91 G0\nX10000000\nM2"),
              "E_RANGE f.ngc:2: coordinate 1e+07 mm; expected at most 1e+06 mm "
              "(--max-extent)");
}

TEST(ParseGcode, RefusesOptionsOutOfTheirDomain)
{
    EXPECT_THROW(read_gcode("M2", {.arc_tolerance_mm = 0}), DomainError);
}

}  // namespace
}  // namespace endmill
