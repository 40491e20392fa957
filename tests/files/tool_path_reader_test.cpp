// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_path_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/files/path_file.h"
#include "path_conditions.h"
#include "planned_path.h"
#include "temporary_folder.h"
#include "wavy_path.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string header =
    "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z";

std::string tool_path_reader_complaint(const std::string& text,
                                       const ReadLimits& limits = {})
{
    return complaint_of([&] { parse_tool_path(text, "f.csv", limits); });
}

// The normal of each point, zero where it is unknown.
std::vector<Vec3> normals_of(const ToolPath& path)
{
    std::vector<Vec3> found;
    for (const PathPoint& point : path.points)
        found.push_back(point.normal() ? *point.normal() : Vec3{0, 0, 0});
    return found;
}

ToolPath path_with_conditions()
{
    ToolPath path = wavy_path(4, 300);
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        path.points[k].patch = int(k % 3);
        if (k % 2 == 0)
            path.points[k].conditions.feed_mm_per_min = 100 + 1.0 / (1 + double(k));
        if (k % 5 != 0)
            path.points[k].conditions.spindle_rpm = 1e4 / 3;
        if (k % 7 != 0)
            path.points[k].conditions.tool = int(k % 4);
    }
    return path;
}

// A machine of two axes, and a path of two poses that it interpolates.
ToolPath machine_path_of_two_points()
{
    ToolPath path;
    path.machine = MachineMotion{.interpolation = Interpolation::Joint};
    PartOnMachine& setup = path.machine->setup;
    setup.machine.configuration = configuration_from_word("W/caxyBz/T");
    setup.machine.rotary = widest_limits(setup.machine.configuration);
    setup.tool_length = 70;
    for (const RotaryPositions& rotary :
         {RotaryPositions{0.1, -0.2}, RotaryPositions{7, -0.3}}) {
        const AxisPositions at = axis_positions(setup, rotary, Vec3{1, 2, 3});
        path.machine->positions.push_back(at);
        path.points.push_back({.pass = 0,
                               .point = static_cast<int>(path.points.size()),
                               .move = Move::Cut,
                               .location = tool_location(setup, at)});
    }
    return path;
}

TEST(ToolPathReader, ReadsThePositionsOfAMachine)
{
    const ToolPath path = machine_path_of_two_points();
    std::optional<MachineMotion> machine = path.machine;
    machine->positions.clear();
    const std::string text = tool_path_csv(path);
    EXPECT_THAT(text, HasSubstr(",x_mm,y_mm,z_mm,r1_deg,r2_deg\n"));
    const Program read = parse_tool_path(text, "f", {}, machine);
    ASSERT_TRUE(read.path.machine);
    EXPECT_EQ(read.path.interpolation(), Interpolation::Joint);
    for (std::size_t i = 0; i < 2; ++i) {
        const AxisPositions& expected = path.machine->positions[i];
        const AxisPositions& found = read.path.machine->positions[i];
        EXPECT_EQ(found.xyz, expected.xyz);
        EXPECT_NEAR(found.rotary[0], expected.rotary[0], 1e-14);
        EXPECT_NEAR(found.rotary[1], expected.rotary[1], 1e-14);
    }
    EXPECT_THAT(parse_tool_path(text, "f").remarks,
                ElementsAre(HasSubstr("positions of a machine are ignored")));
}

TEST(ToolPathReader, RefusesPositionsThatAreNotThoseOfThePose)
{
    ToolPath path = machine_path_of_two_points();
    std::optional<MachineMotion> machine = path.machine;
    const auto complaint = [&](const std::string& text) {
        return complaint_of([&] { parse_tool_path(text, "f", {}, machine); });
    };
    path.machine->positions[1].xyz.x() += 1e-5;
    EXPECT_THAT(complaint(tool_path_csv(path)),
                HasSubstr("E_CSV f:3: the positions of the machine are "));
    ToolPath plain = path;
    plain.machine.reset();
    EXPECT_EQ(complaint(tool_path_csv(plain)),
              "E_CSV f:1: no columns x_mm, y_mm, z_mm, r1_deg and r2_deg; expected "
              "positions of the machine: the interpolation of the path is joint");
    EXPECT_THAT(complaint("tip_x_mm,tip_y_mm,tip_z_mm,x_mm,y_mm,z_mm,r1_deg,r2_deg\n"
                          "1,2,3,4,5,6,,8\n"),
                HasSubstr("E_CSV f:2: r1_deg is empty"));
    EXPECT_THAT(complaint("tip_x_mm,tip_y_mm,tip_z_mm,x_mm,y_mm,z_mm,r1_deg\n"),
                HasSubstr("no column \"r2_deg\""));
}

TEST(ToolPathReader, ReadsAWrittenPathToTheLastBit)
{
    const ToolPath path = wavy_path(5, 400);
    const Program read = parse_tool_path(tool_path_csv(path), "f");
    EXPECT_TRUE(test::are_equal(read.path, path));
    EXPECT_EQ(test::conditions_of(read.path), test::conditions_of(path));
    EXPECT_TRUE(read.remarks.empty());
    EXPECT_FALSE(read.cutter);
    EXPECT_EQ(read.position_error_mm, 0);
}

TEST(ToolPathReader, ReadsConditionsAndPatchesToTheBit)
{
    const ToolPath path = path_with_conditions();
    const std::string text = tool_path_csv(path);
    const Program read = parse_tool_path(text, "f");
    EXPECT_TRUE(test::are_equal(read.path, path));
    EXPECT_EQ(test::conditions_of(read.path), test::conditions_of(path));
    EXPECT_EQ(read.path.points[2].patch, 2);
    EXPECT_EQ(tool_path_csv(read.path), text);
}

// Long enough to be read in several runs of lines.
TEST(ToolPathReader, ReadsALongPathExactlyAndReportsItsFirstError)
{
    ToolPath path = wavy_path(30, 400);
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        path.points[k].known_contact = {};
        if (k % 3 == 0)
            path.points[k].known_contact = Vec3{0.6, 0, 0.8};
    }
    std::string text = tool_path_csv(path);
    ASSERT_GT(text.size(), 1U << 19);
    const Program read = parse_tool_path(text, "f");
    EXPECT_TRUE(test::are_equal(read.path, path));
    EXPECT_EQ(normals_of(read.path), normals_of(path));

    for (const std::size_t row : {std::size_t{11900}, std::size_t{6000}}) {
        std::size_t at = 0;
        for (std::size_t line = 0; line <= row; ++line)
            at = text.find('\n', at) + 1;
        text[at] = 'x';
        EXPECT_THAT(tool_path_reader_complaint(text),
                    HasSubstr("f.csv:" + std::to_string(row + 2) + ": pass is \"x"));
    }
}

TEST(ToolPathReader, NeedsOnlyTipsAndStatesItsAssumptions)
{
    const Program read =
        parse_tool_path("tip_z_mm,tip_x_mm,tip_y_mm\r\n3,1,2\r\n6,+4,5e0\r\n", "f");
    ASSERT_EQ(read.path.points.size(), 2U);
    EXPECT_EQ(read.path.points[0].location.tip, (Vec3{1, 2, 3}));
    EXPECT_EQ(read.path.points[1].location.tip, (Vec3{4, 5, 6}));
    EXPECT_EQ(read.path.points[1].location.axis, (Vec3{0, 0, 1}));
    EXPECT_EQ(read.path.points[1].move, Move::Cut);
    EXPECT_EQ(read.path.points[1].point, 1);
    EXPECT_THAT(read.remarks, ElementsAre(HasSubstr("assumed to be a cut"),
                                          HasSubstr("assumed to be +z")));
}

TEST(ToolPathReader, IgnoresColumnsThatAPathCannotHoldWithARemark)
{
    const Program read = parse_tool_path(
        header +
            ",contact_x_mm,contact_y_mm,contact_z_mm,feed_mm_per_min,limit\n"
            "0,0,cut,1,2,3,0,0,1,4,5,6,100,cutting_force\n"
            "0,1,rapid,1,2,3,0,0,1,,,,,\n",
        "f");
    EXPECT_FALSE(read.path.points[0].contact());
    EXPECT_THAT(test::conditions_of(read.path),
                ElementsAre(CuttingConditions{100, {}, {}}, CuttingConditions{}));
    EXPECT_THAT(read.remarks, ElementsAre(HasSubstr("contacts are ignored")));
}

TEST(ToolPathReader, ScalesAnAxisOfFourDecimals)
{
    const Program read =
        parse_tool_path(header + "\n0,0,cut,0,0,0,0.5774,0.5774,0.5774\n", "f");
    EXPECT_NEAR(read.path.points[0].location.axis.norm(), 1, 1e-15);
}

TEST(ToolPathReader, RefusesBadCellsWithTheLine)
{
    struct Bad {
        std::string row;
        std::string complaint;
    };
    for (const auto& [row, complaint] : std::vector<Bad>{
             {"0,1,cut,nan,0,0,0,0,1", "tip_x_mm is \"nan\"; expected a number"},
             {"0,1,cut,0,inf,0,0,0,1", "tip_y_mm is \"inf\"; expected a number"},
             {"0,1,cut,0,0,1e999,0,0,1", "tip_z_mm is \"1e999\"; expected a number"},
             {"0,1,cut,0,0,1 ,0,0,1", "tip_z_mm is \"1 \"; expected a number"},
             {"0,1,cut,0,,0,0,0,1", "tip_y_mm is empty; expected a number"},
             {"0,1,cut,,,,0,0,1", "tip_x_mm is empty; expected a number"},
             {"0,1,cut,0,0,2e6,0,0,1", "tip_z_mm is 2e+06; expected at most 1e+06 mm"},
             {"0,1,drill,0,0,0,0,0,1", "move is \"drill\"; expected cut, link, rapid"},
             {"0,1,Cut,0,0,0,0,0,1", "move is \"Cut\"; expected cut, link, rapid"},
             {"0,1,,0,0,0,0,0,1", "move is empty"},
             {"0,1,cut,0,0,0,0,0,1.001",
              "axis of length 1.001; expected length 1 within 1e-04"},
             {"0,1,cut,0,0,0,0,0,0", "of length 0; expected"},
             {"0,1,cut,0,0,0,1e300,1e300,0", "of length infinity; expected"},
             {"0,1,cut,0,0,0,0,,1", "axis_y is empty; expected a number, as in"},
             {"-1,1,cut,0,0,0,0,0,1", "pass is \"-1\"; expected a whole number"},
             {"0,1.5,cut,0,0,0,0,0,1", "point is \"1.5\"; expected a whole number"},
             {"99999999999,1,cut,0,0,0,0,0,1", "pass is \"99999999999\""},
             {"0,1,cut,0,0,0,0,0", "row has 8 cells; expected 9"},
             {"0,1,cut,0,0,0,0,0,1,", "row has 10 cells; expected 9"},
             {"", "row has 1 cell; expected 9"},
             {"0,1,\"cut,0,0,0,0,0,1", "a quote that is not closed"}}) {
        std::string text = header + "\n0,0,cut,0,0,0,0,0,1\n";
        text += row + '\n';
        const std::string found = tool_path_reader_complaint(text);
        EXPECT_THAT(found, HasSubstr(" f.csv:3: ")) << row;
        EXPECT_THAT(found, HasSubstr(complaint)) << row;
    }
}

TEST(ToolPathReader, RefusesConditionsOutOfTheirDomain)
{
    const auto about = [](const std::string& cells) {
        return tool_path_reader_complaint(
            "tip_x_mm,tip_y_mm,tip_z_mm,feed_mm_per_min,spindle_rpm,tool\n"
            "0,0,0," +
            cells + "\n");
    };
    EXPECT_EQ(about("1,2,3"), "accepted");
    EXPECT_EQ(about(",,"), "accepted");
    EXPECT_THAT(about("-5,,"), HasSubstr("f.csv:2: feed_mm_per_min is \"-5\""));
    EXPECT_THAT(about("0,,"), HasSubstr("feed_mm_per_min is \"0\""));
    EXPECT_THAT(about("nan,,"), HasSubstr("feed_mm_per_min is \"nan\""));
    EXPECT_THAT(about(",0,"), HasSubstr("spindle_rpm is \"0\""));
    EXPECT_THAT(about(",-1,"), HasSubstr("spindle_rpm is \"-1\""));
    EXPECT_THAT(about(",,-1"), HasSubstr("tool is \"-1\""));
    EXPECT_THAT(about(",,1.0"), HasSubstr("tool is \"1.0\""));
}

TEST(ToolPathReader, RefusesAContactThatIsNotWhole)
{
    const std::string all =
        "tip_x_mm,tip_y_mm,tip_z_mm,u,v,contact_x_mm,contact_y_mm,"
        "contact_z_mm,normal_x,normal_y,normal_z\n";
    EXPECT_EQ(tool_path_reader_complaint(all + "0,0,0,.5,.5,1,2,3,0,0,1\n"), "accepted");
    EXPECT_THAT(tool_path_reader_complaint(all + "0,0,0,,.5,1,2,3,0,0,1\n"),
                HasSubstr("u is empty"));
    EXPECT_THAT(tool_path_reader_complaint(all + "0,0,0,.5,.5,,,,0,0,1\n"),
                HasSubstr("contact_x_mm is empty; expected all of u, v, contact"));
    EXPECT_THAT(tool_path_reader_complaint(all + "0,0,0,.5,.5,1,2,3,0,0,2\n"),
                HasSubstr("length 2"));
    EXPECT_THAT(tool_path_reader_complaint(all + "0,0,0,.5,.5,1,2,3e6,0,0,1\n"),
                HasSubstr("E_RANGE"));
}

TEST(ToolPathReader, RefusesATableWithoutRows)
{
    EXPECT_THAT(tool_path_reader_complaint(header + "\n"),
                HasSubstr("f.csv:1: no row after the header"));
    EXPECT_THAT(tool_path_reader_complaint(""),
                HasSubstr("f.csv:1: no column \"tip_x_mm\""));
}

TEST(ToolPathReader, KeepsItsLimits)
{
    const std::string text = tool_path_csv(wavy_path(10, 1000));
    EXPECT_THAT(tool_path_reader_complaint(text, {.max_memory_gib = 1e-4}),
                HasSubstr("E_LIMIT"));
    EXPECT_THAT(tool_path_reader_complaint(text, {.max_extent_mm = 100}),
                HasSubstr("(--max-extent)"));
}

TEST(ToolPathReader, ReadsFiles)
{
    const TemporaryFolder folder;
    const auto file = folder.put("path.csv", tool_path_csv(wavy_path(2, 5)));
    EXPECT_EQ(read_tool_path(file).path.points.size(), 12U);
    EXPECT_THAT(complaint_of([&] { read_tool_path(folder.path()); }),
                HasSubstr("E_OPEN"));
}

TEST(ToolPathReader, KeepsANormalWithoutTheRestOfItsContact)
{
    const Program read = parse_tool_path(
        "tip_x_mm,tip_y_mm,tip_z_mm,normal_x,normal_y,normal_z\n"
        "0,0,0,,,\n1,0,0,0,0.6,0.8\n2,0,0,,,\n",
        "f");
    EXPECT_FALSE(read.path.points[0].normal());
    EXPECT_EQ(*read.path.points[1].normal(), (Vec3{0, 0.6, 0.8}));
    EXPECT_FALSE(read.path.points[2].normal());
    EXPECT_FALSE(read.path.points[1].contact());
    // The normal is also written and read again beside complete contacts.
    const std::string text = tool_path_csv(read.path);
    const Program again = parse_tool_path(text, "f");
    EXPECT_EQ(normals_of(again.path), normals_of(read.path));
    EXPECT_EQ(tool_path_csv(again.path), text);
}

TEST(ToolPathReader, FindsTheLineOfARow)
{
    const std::string text = "tip_x_mm,tip_y_mm,tip_z_mm\r\n0,0,0\n1,0,0\n2,0,0";
    EXPECT_EQ(line_of_row(text, 0), 2U);
    EXPECT_EQ(line_of_row(text, 2), 4U);
}

}  // namespace
}  // namespace endmill
