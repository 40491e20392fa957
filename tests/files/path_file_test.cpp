// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/path_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/post/apt.h"
#include "endmill/post/gcode_writer.h"
#include "temporary_folder.h"
#include "wavy_path.h"

namespace endmill {
namespace {

using testing::HasSubstr;

constexpr const char* canonical =
    "    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)\n"
    "    2 N..... STRAIGHT_TRAVERSE(0.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)\n"
    "    3 N2     SET_FEED_RATE(100.0000)\n"
    "    4 N2     STRAIGHT_FEED(1.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)\n"
    "    5 N..... PROGRAM_END()\n";

TEST(PathFile, FormatFollowsTheContentBeforeTheName)
{
    const ToolPath path = wavy_path(2, 3);
    for (const char* name : {"x", "x.txt", "x.ngc", "x.apt", "x.csv"}) {
        EXPECT_EQ(path_format(tool_path_csv(path), name), PathFormat::Csv) << name;
        EXPECT_EQ(path_format("\"tip_x_mm\",tip_y_mm,tip_z_mm\n", name), PathFormat::Csv);
    }
    for (const char* name : {"x", "x.txt", "x.ngc"}) {
        EXPECT_EQ(path_format(apt(path, {.feed_mm_per_min = 1}).text, name),
                  PathFormat::Apt);
        EXPECT_EQ(path_format(canonical, name), PathFormat::Canonical);
    }
    for (const char* name : {"x", "x.txt", "x.NGC"}) {
        EXPECT_EQ(path_format(
                      gcode(path, {.name = "tip_a, b", .feed_mm_per_min = 1}).text, name),
                  PathFormat::Gcode);
        for (const char* text :
             {"G1 X1", "\n g 1 x 2", "(tip_x, y)\nG0", ";x", "/G0 X1", "N10 G21", ":1001",
              "x-1.5", "\xef\xbb\xbfG0 X0", "o<sub> call"})
            EXPECT_EQ(path_format(text, "x.ngc"), PathFormat::Gcode) << text;
    }
}

TEST(PathFile, FormatFollowsTheNameIfTheContentIsDamaged)
{
    EXPECT_EQ(path_format("x,y,z\n1,2,3\n", "x.csv"), PathFormat::Csv);
    EXPECT_EQ(path_format("FROM/1,2,3\n", "x.CL"), PathFormat::Apt);
    EXPECT_EQ(path_format("hello\n", "x.tap"), PathFormat::Gcode);
}

TEST(PathFile, RefusesOtherKindsOfFilesByName)
{
    const auto about = [](std::string_view content, const char* name) {
        return complaint_of([&] { path_format(content, name); });
    };
    EXPECT_THAT(
        about("solid x\nfacet normal 0 0 1\n", "x.ngc"),
        HasSubstr("E_FORMAT x.ngc: content looks like STL; expected a tool path"));
    EXPECT_THAT(about("{\"format\": \"endmill-surface/1\"}", "x.csv"), HasSubstr("JSON"));
    EXPECT_THAT(about("v 1 2 3\nf 1 2 3\n", "x.txt"), HasSubstr("OBJ"));
    EXPECT_THAT(about("OFF\n3 1 0\n", "x"), HasSubstr("OFF"));
    EXPECT_THAT(about("ply\n", "x"), HasSubstr("PLY"));
    EXPECT_THAT(about("<html>", "x.ngc"), HasSubstr("XML"));
    EXPECT_THAT(about(std::string_view{"G1 X1\0Y2", 8}, "x.ngc"), HasSubstr("binary"));
    EXPECT_THAT(about("hello world\n", "x.txt"), HasSubstr("content is not recognised"));
    EXPECT_THAT(about("1,2,3\n", "x.txt"), HasSubstr("content is not recognised"));
}

TEST(PathFile, ReadsEveryKind)
{
    const TemporaryFolder folder;
    const ToolPath path = wavy_path(2, 3);
    const auto points = [&](const std::string& name, const std::string& text) {
        return read_program(folder.put(name, text)).path.points.size();
    };
    EXPECT_EQ(points("a.csv", tool_path_csv(path)), path.points.size());
    EXPECT_EQ(points("a.apt", apt(path, {.feed_mm_per_min = 1}).text),
              path.points.size());
    EXPECT_EQ(points("a.ngc", gcode(path, {.feed_mm_per_min = 1}).text),
              path.points.size() + 2);
    EXPECT_EQ(points("a.txt", canonical), 2U);
}

TEST(PathFile, LimitsEveryKind)
{
    const TemporaryFolder folder;
    const ToolPath path = wavy_path(2, 3);
    PathReadOptions options;
    options.limits.max_extent_mm = 150;
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"a.csv", tool_path_csv(path)},
             {"a.apt", apt(path, {.feed_mm_per_min = 1}).text},
             {"a.ngc", gcode(path, {.feed_mm_per_min = 1}).text}}) {
        const auto file = folder.put(name, text);
        EXPECT_THAT(complaint_of([&] { read_program(file, options); }),
                    HasSubstr("E_RANGE"))
            << name;
    }
}

TEST(PathFile, RefusesUnreadableFiles)
{
    const TemporaryFolder folder;
    const auto about = [](const std::filesystem::path& file) {
        return complaint_of([&] { read_program(file); });
    };
    EXPECT_THAT(about(folder.path() / "none.ngc"), HasSubstr("E_OPEN"));
    EXPECT_THAT(about(folder.path()), HasSubstr("E_OPEN"));
    EXPECT_THAT(about(folder.put("a.ngc", "")), HasSubstr("E_EMPTY"));
    EXPECT_THAT(about(folder.put("a.ngc", "\x1f\x8b\x08")), HasSubstr("E_COMPRESSED"));
}

}  // namespace
}  // namespace endmill
