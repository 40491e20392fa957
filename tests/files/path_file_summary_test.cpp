// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/path_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::HasSubstr;

std::string path_file_summary_complaint(const std::string& summary)
{
    const TemporaryFolder folder;
    folder.put("summary.json", summary);
    return complaint_of([&] { read_path_summary(folder.path() / "toolpath.csv"); });
}

TEST(PathSummary, IsReadFromTheFileBesideThePath)
{
    const TemporaryFolder folder;
    folder.put("summary.json",
               R"({"name": "net", "cutter": "bull:10:2", "chord_tolerance_mm": 0.5,
                   "inner_tolerance_mm": 0.02, "outer_tolerance_mm": 0.1, "scallop_mm": 1,
                   "feed_mm_per_min": 800, "spindle_rpm": 5000, "axis": [0, 0, 1],
                   "inaccessible": "report", "part": "../a.stl", "part_up": "y",
                   "skip_facets": "../bottom.txt",
                   "protected": "wall.stl", "protected_units": "inch"})");
    const auto summary = read_path_summary(folder.path() / "toolpath.csv");
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->name, "net");
    EXPECT_EQ(summary->cutter, (Cutter{5, 2}));
    EXPECT_EQ(summary->tolerance_mm(), 0.02);
    EXPECT_EQ(summary->scallop_mm, 1);
    EXPECT_EQ(summary->feed_mm_per_min, 800);
    EXPECT_EQ(summary->spindle_rpm, 5000);
    EXPECT_EQ(summary->inaccessible, InaccessibleStock::Report);
    ASSERT_TRUE(summary->part && summary->protected_part);
    EXPECT_EQ(summary->part->up, UpAxis::Y);
    EXPECT_EQ(summary->part->units, LengthUnit::Mm);
    EXPECT_EQ(summary->protected_part->file, folder.path() / "wall.stl");
    EXPECT_EQ(summary->protected_part->units, LengthUnit::Inch);
    EXPECT_EQ(summary->protected_part->up, UpAxis::Z);
    EXPECT_EQ(summary->skipped_facets, folder.path() / "../bottom.txt");
}

// With an outer tolerance of 0 the scallop height limits what remains.
TEST(PathSummary, OuterToleranceOfZeroIsNoTolerance)
{
    const TemporaryFolder folder;
    folder.put("summary.json",
               R"({"inner_tolerance_mm": 0.05, "outer_tolerance_mm": 0})");
    EXPECT_EQ(read_path_summary(folder.path() / "toolpath.csv")->tolerance_mm(), 0.05);
    folder.put("summary.json",
               R"({"inner_tolerance_mm": 0, "outer_tolerance_mm": 0.05})");
    EXPECT_EQ(read_path_summary(folder.path() / "toolpath.csv")->tolerance_mm(), 0);
}

TEST(PathSummary, MayBeMissingOrEmpty)
{
    const TemporaryFolder folder;
    EXPECT_FALSE(read_path_summary(folder.path() / "toolpath.csv"));
    folder.put("summary.json", R"({"cutter": null, "u": {"cutter": 1}})");
    const auto summary = read_path_summary(folder.path() / "toolpath.csv");
    ASSERT_TRUE(summary);
    EXPECT_FALSE(summary->cutter || summary->name || summary->feed_mm_per_min);
    EXPECT_FALSE(summary->tolerance_mm());
    EXPECT_FALSE(summary->inaccessible);
    EXPECT_THAT(path_file_summary_complaint(R"({"inaccessible": "all"})"),
                HasSubstr("one of count, report"));
}

TEST(PathSummary, MayNameTheMachineThatInterpolatesThePath)
{
    const TemporaryFolder folder;
    folder.put("summary.json",
               R"({"interpolation": "tcp", "machine": {"configuration": "W/caxyBz/T",
                   "pivot_mm": 5, "table_offset_mm": [1, 2, 3], "axis_offset_mm": [0, 4, 0],
                   "tool_length_mm": 70, "word_sign": {"c": -1},
                   "part_to_machine": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]],
                   "clamp_mm": [7, 8, 9]}})");
    const auto summary = read_path_summary(folder.path() / "toolpath.csv");
    ASSERT_TRUE(summary && summary->machine);
    EXPECT_EQ(summary->machine->interpolation, Interpolation::Tcp);
    const PartOnMachine& setup = summary->machine->setup;
    EXPECT_EQ(setup.machine.configuration.word, "W/caxyBz/T");
    EXPECT_EQ(setup.machine.pivot, 5);
    EXPECT_EQ(setup.machine.table_offset, Vec3(1, 2, 3));
    EXPECT_EQ(setup.machine.axis_offset, Vec3(0, 4, 0));
    EXPECT_EQ(setup.machine.word_signs, (RotaryPositions{-1, 1}));
    EXPECT_EQ(setup.tool_length, 70);
    EXPECT_EQ(setup.part_to_machine.row(0), (Eigen::RowVector3d{0, 1, 0}));
    EXPECT_EQ(setup.clamp, Vec3(7, 8, 9));
    const ClampedPart pose = [&] {
        folder.put("pose.json",
                   R"({"part_to_machine": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]],
                       "clamp_mm": [7, 8, 9], "type": "CA"})");
        return read_clamped_part(folder.path() / "pose.json");
    }();
    EXPECT_EQ(pose.part_to_machine, setup.part_to_machine);
    EXPECT_EQ(pose.clamp, Vec3(7, 8, 9));
}

// The summary of `feed` has a file under the key machine.
TEST(PathSummary, OfALinearPathHasNoMachine)
{
    const TemporaryFolder folder;
    folder.put("summary.json", R"({"interpolation": "linear", "machine": "m.json"})");
    EXPECT_FALSE(read_path_summary(folder.path() / "toolpath.csv")->machine);
    EXPECT_THAT(path_file_summary_complaint(R"({"interpolation": "joint"})"),
                HasSubstr("no key machine"));
    EXPECT_THAT(path_file_summary_complaint(
                    R"({"interpolation": "joint", "machine": {"configuration": "W/x"}})"),
                HasSubstr("/machine/configuration"));
    EXPECT_THAT(path_file_summary_complaint(
                    R"({"interpolation": "joint", "machine": {"configuration":
                        "W/caxyBz/T", "part_to_machine": [[1,0,0],[0,1,0],[0,0,-1]]}})"),
                HasSubstr("no rotation"));
}

TEST(PathSummary, MayHaveAToleranceOfZeroOnOneSide)
{
    const TemporaryFolder folder;
    folder.put("summary.json", R"({"inner_tolerance_mm": 0, "outer_tolerance_mm": 0.1})");
    const auto summary = read_path_summary(folder.path() / "toolpath.csv");
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->inner_tolerance_mm, 0);
    EXPECT_EQ(summary->tolerance_mm(), 0);
}

// The first digest is printed in FIPS 180-2, appendix B.1; the second is that of no text.
TEST(PathSummary, HasTheDigestOfTheStandard)
{
    EXPECT_EQ(content_sha256("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(content_sha256(""),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    ContentSha256 pieces;
    for (const char* piece : {"a", "", "bc"})
        pieces.add(piece);
    EXPECT_EQ(pieces.word(), content_sha256("abc"));
}

TEST(PathSummary, BelongsToTheFileWhoseDigestItNames)
{
    const std::string table = "tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n1,0,0\n";
    PathSummary summary;
    EXPECT_EQ(summary_match(summary, table), SummaryMatch::Unnamed);
    summary.toolpath_sha256 = content_sha256(table);
    EXPECT_EQ(summary_match(summary, table), SummaryMatch::Described);
    EXPECT_EQ(summary_match(summary, table + "2,0,0\n"), SummaryMatch::Other);
    summary.toolpath_points = 2;
    EXPECT_EQ(summary_match(summary, table), SummaryMatch::Described);
    summary.toolpath_points = 3;
    EXPECT_EQ(summary_match(summary, table), SummaryMatch::Other);
    summary.program_sha256 = content_sha256("G0 X1\nM2\n");
    EXPECT_EQ(summary_match(summary, "G0 X1\nM2\n"), SummaryMatch::Described);
    EXPECT_EQ(summary_match(summary, "G0 X2\nM2\n"), SummaryMatch::Other);
}

TEST(PathSummary, IsReadStrictly)
{
    EXPECT_THAT(path_file_summary_complaint("{"), HasSubstr("E_JSON"));
    EXPECT_THAT(path_file_summary_complaint("[1]"), HasSubstr("E_JSON"));
    EXPECT_THAT(path_file_summary_complaint(R"({"cutter": "bal:10"})"),
                HasSubstr("summary.json:/cutter: \"bal:10\"; expected ball:DIAMETER"));
    EXPECT_THAT(path_file_summary_complaint(R"({"cutter": 10})"),
                HasSubstr(":/cutter: 10"));
    EXPECT_THAT(path_file_summary_complaint(R"({"name": 1})"), HasSubstr(":/name: 1"));
    EXPECT_THAT(path_file_summary_complaint(R"({"chord_tolerance_mm": 0})"),
                HasSubstr(":/chord_tolerance_mm: 0; expected a number above 0"));
    EXPECT_THAT(path_file_summary_complaint(R"({"inner_tolerance_mm": -0.1})"),
                HasSubstr(":/inner_tolerance_mm: -0.1; expected a number from 0"));
    EXPECT_THAT(path_file_summary_complaint(R"({"feed_mm_per_min": "fast"})"),
                HasSubstr(":/feed_mm_per_min: \"fast\"; expected a number"));
    EXPECT_THAT(path_file_summary_complaint(R"({"toolpath_points": -1})"),
                HasSubstr(":/toolpath_points: -1"));
    EXPECT_THAT(path_file_summary_complaint(R"({"toolpath_sha256": 7})"),
                HasSubstr(":/toolpath_sha256: 7"));
}

}  // namespace
}  // namespace endmill
