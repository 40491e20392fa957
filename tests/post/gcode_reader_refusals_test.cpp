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
                "E_GCODE f.ngc:3: A5; expected A0, or the machine of the program "
                "(--machine and --frame)"},
        Refused{"\nB-0.5",
                "E_GCODE f.ngc:4: B-0.5; expected B0, or the machine of the program "
                "(--machine and --frame)"},
        Refused{"G10 L2 P1 X0",
                "E_GCODE f.ngc:3: setting of offsets G10; expected coordinates in one "
                "coordinate system of the part: --interpreter linuxcnc applies offsets"},
        Refused{"X1 L2",
                "E_GCODE f.ngc:3: word L; expected L only beside a canned cycle or an M "
                "code that takes it"},
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
        Refused{"G1 Q5 F9",
                "E_GCODE f.ngc:3: word Q; expected Q only beside G64, G73 or G83"},
        Refused{"S-5", "E_GCODE f.ngc:3: a spindle speed S-5; expected S >= 0"},
        Refused{"T-1", "E_GCODE f.ngc:3: a tool T-1; expected a whole number from 0"},
        Refused{"T1.5", "E_GCODE f.ngc:3: a tool T1.5; expected a whole number from 0"},
        Refused{"T4294967296",
                "E_GCODE f.ngc:3: a tool T4.29497e+09; expected a whole number from 0"},
        Refused{"X1 Y2 X3",
                "E_GCODE f.ngc:3: word X twice in a block; expected the word once"}));

INSTANTIATE_TEST_SUITE_P(
    Cycles, RefusedProgram,
    testing::Values(
        Refused{"F9\nG81 X1 Z-1",
                "E_GCODE f.ngc:4: G81 without R; expected R, the level above the hole "
                "where the feed begins"},
        Refused{"F9\nG81 X1 R1",
                "E_GCODE f.ngc:4: G81 without Z; expected Z, the depth of the hole"},
        Refused{"F9\nG18 G81 X1 R1 Z2",
                "E_GCODE f.ngc:4: G81 without Y; expected Y, the depth of the hole"},
        Refused{"F9\nG83 X1 Z-1 R1",
                "E_GCODE f.ngc:4: G83 without Q; expected Q, the depth of a peck"},
        Refused{"F9\nG73 X1 Z-1 R1 Q0", "E_GCODE f.ngc:4: a peck of Q0; expected Q > 0"},
        Refused{"F9\nG81 X1 Z-1 R1\nG82 X2 Z-1",
                "E_GCODE f.ngc:5: G82 without R; expected R, the level above the hole "
                "where the feed begins"},
        Refused{"F9\nG81 X1 Z-1 R1\nG80\nG81 X2 Z-1",
                "E_GCODE f.ngc:6: G81 without R; expected R, the level above the hole "
                "where the feed begins"},
        Refused{"F9\nG81 X1 Z2 R1",
                "E_GCODE f.ngc:4: R at 1 mm, below the depth at 2 mm; expected R above "
                "the depth"},
        Refused{"F9\nG81 X1 Z-1 R1 L0",
                "E_GCODE f.ngc:4: L0 holes of a canned cycle; expected a whole number "
                "from 1"},
        Refused{"F9\nG81 X1 Z-1 R1 L1.5",
                "E_GCODE f.ngc:4: L1.5 holes of a canned cycle; expected a whole number "
                "from 1"},
        Refused{"F9\nG81 X1 Z-1 R1 L2 K2",
                "E_GCODE f.ngc:4: words L and K in a canned cycle; expected one number "
                "of holes"},
        Refused{"F9\nG81 X1 Z-1 R1 Q1",
                "E_GCODE f.ngc:4: word Q beside G81; expected Q only beside G73 or G83"},
        Refused{"F9\nG83 X1 Z-1 R1 I1",
                "E_GCODE f.ngc:4: word I in a canned cycle; expected the words X, Y, Z, "
                "R, Q, P and L"},
        Refused{"F9\nG82 X1 Z-1 R1 P-1", "E_GCODE f.ngc:4: a dwell P-1; expected P >= 0"},
        Refused{"F9\nG81",
                "E_GCODE f.ngc:4: a canned cycle without X, Y and Z; expected a position "
                "of a hole"},
        Refused{"G81 X1 Z-1 R1",
                "E_GCODE f.ngc:3: a move at feed before any F; expected F > 0"},
        Refused{"G93 G81 X1 Z-1 R1 F9",
                "E_GCODE f.ngc:3: a canned cycle under G93; expected G94"},
        Refused{"F9\nG81 X1 Z-1 R1\nG2 R5",
                "E_GCODE f.ngc:5: a full circle by R; expected its centre: I, J, K"}));

const char* const away =
    "E_GCODE f.ngc:5: a cut from an unknown position after the reference move of line 4; "
    "expected a rapid to an absolute Z before it";

INSTANTIATE_TEST_SUITE_P(
    ReferenceMoves, RefusedProgram,
    testing::Values(
        Refused{"G91 G1 X5 Z-1 F9\nG28 Z0\nG1 X1", away},
        Refused{"G1 X5 Z-1 F9\nG91 G28 Z0\nG90 G1 Z-1", away},
        Refused{"G1 X5 Z-1 F9\nG91 G28 Z0\nG90 G2 X1 I5", away},
        Refused{"G1 X5 Z-1 F9\nG91 G28 Z0\nG90 G81 X1 Z-1 R1", away},
        Refused{"G1 X5 Z-1 F9\nG28 X0",
                "E_GCODE f.ngc:4: a sideways move to a position of the machine at z -1 "
                "mm, not above the cuts (up to z -1 mm); expected a move up before it"},
        Refused{"G53 X0 Z0\nG1 Z0 F9",
                "E_GCODE f.ngc:4: a cut from an unknown position after the reference "
                "move of line 3; expected a rapid to an absolute X Z before it"},
        Refused{"G1 F9\nG53 X0",
                "E_GCODE f.ngc:4: a move in machine coordinates (G53) without G0; "
                "expected G0, a rapid"},
        Refused{"G53", "E_GCODE f.ngc:3: G53 without X, Y and Z; expected an axis word"},
        Refused{"G91 G53 Z0", "E_GCODE f.ngc:3: G53 under G91; expected G90"},
        Refused{
            "G1 X5 Z-1 F9\nG28\nG90 G0 X9 Y9 Z5\nG81 X1 Z-1 R1",
            "E_GCODE f.ngc:4: a move of all axes at once to a position of the machine "
            "at z -1 mm, not above the cuts (up to z -1 mm), and a cut after it; "
            "expected a move up before it, such as G91 G28 Z0"},
        Refused{"G55",
                "E_GCODE f.ngc:3: G55 after positions in G54, with which controls begin; "
                "expected one coordinate system"},
        Refused{"G54\nG55",
                "E_GCODE f.ngc:4: G55 after G54; expected one coordinate system"},
        Refused{"G92.1 X1",
                "E_GCODE f.ngc:3: X, Y or Z beside G92.1; expected the code alone"}));

TEST(ParseGcode, RefusesProgramsWithoutMotionOrPosition)
{
    EXPECT_EQ(
        gcode_refusal("%\nG21\nM30\n%\n"),
        "E_GCODE f.ngc: no motion in 3 lines; expected at least one G0, G1, G2 or G3 "
        "with coordinates");
    EXPECT_EQ(
        gcode_refusal("G21 G0 X0 Y0\nG1 X5 F9\nM2\n"),
        "E_GCODE f.ngc: no absolute Z in 3 lines; expected a position of X, Y and Z "
        "before the first cut");
    EXPECT_EQ(gcode_refusal("G21 G91 G0 X0 Y0 Z1\nM2\n"),
              "E_GCODE f.ngc: no absolute X Y Z in 2 lines; expected a position of X, Y "
              "and Z before the first cut");
}

TEST(ParseGcode, RefusesASecondProgramInAFile)
{
    EXPECT_EQ(gcode_refusal("O1 (MAIN)\nG21\nO2 (SUB)\n"),
              "E_GCODE f.ngc:3: a second program \"O2 (SUB)\"; expected one program in a "
              "file");
    EXPECT_EQ(gcode_refusal("o100 sub\n"),
              "E_GCODE f.ngc:1: O-word \"o100 sub\"; expected moves alone: --interpreter "
              "linuxcnc expands subroutines");
    EXPECT_EQ(gcode_refusal("O1 (A) G0\n"),
              "E_GCODE f.ngc:1: words behind the program number \"O1 (A) G0\"; expected "
              "the number in a line of its own");
}

TEST(ParseGcode, RefusesMoreHolesThanThereIsRoomFor)
{
    EXPECT_THAT(gcode_refusal(program_of("F9\nG91 G81 X1 Z-1 R1 L1000000000")),
                StartsWith("E_LIMIT f.ngc:4: a canned cycle of 6e+09 moves"));
    EXPECT_THAT(
        gcode_refusal(program_of("F9\nG83 X1 Z-1 R1 Q0." + std::string(300, '0') + "1")),
        StartsWith("E_LIMIT f.ngc:4: a canned cycle of "));
    EXPECT_EQ(
        gcode_refusal(program_of("F9\nG81 X1 Z-1 R1"), {.most_points = 3}),
        "E_LIMIT f.ngc:4: a canned cycle of 7 moves makes more than the points that "
        "are left (2; --max-memory)");
}

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
