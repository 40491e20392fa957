// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/path_file.h"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/files/csv.h"
#include "path_conditions.h"
#include "wavy_path.h"

namespace endmill {
namespace {

TEST(ToolPathCsv, HasTheColumnsOfTheFormatInTheirOrder)
{
    EXPECT_EQ(tool_path_csv({}),
              "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z,u,v,"
              "contact_x_mm,contact_y_mm,contact_z_mm,normal_x,normal_y,normal_z\n");
}

TEST(ToolPathCsv, WritesAPointByHand)
{
    const ToolPath path{{{0, 0, Move::Rapid, 0, {{0, -0.0, 230}, {0, 0, 1}}},
                         {0,
                          1,
                          Move::Plunge,
                          0,
                          {{1.5, -2, 0.1}, {0, 0, 1}},
                          SurfaceContact{0.25, 2, {{1e-7, 3, -4}, {0.6, 0, 0.8}}}}}};
    EXPECT_THAT(
        tool_path_csv(path),
        testing::EndsWith("\n0,0,rapid,0,0,230,0,0,1,,,,,,,,\n"
                          "0,1,plunge,1.5,-2,0.1,0,0,1,0.25,2,1e-07,3,-4,0.6,0,0.8\n"));
}

TEST(ToolPathCsv, OverSeveralSurfacesNamesThePatch)
{
    const ToolPath path{{{0, 0, Move::Plunge, 0, {{1, 2, 3}, {0, 0, 1}}},
                         {1, 0, Move::Rapid, 4, {{1, 2, 3}, {0, 0, 1}}}}};
    EXPECT_THAT(tool_path_csv(path), testing::HasSubstr(",axis_z,patch,u,v,"));
    EXPECT_THAT(tool_path_csv(path),
                testing::EndsWith("\n0,0,plunge,1,2,3,0,0,1,0,,,,,,,,\n"
                                  "1,0,rapid,1,2,3,0,0,1,4,,,,,,,,\n"));
}

// Optional columns stand at their place in the order, if any point has a value.
TEST(ToolPathCsv, WritesToolFeedAndSpeed)
{
    const ToolPath bare{{{0, 0, Move::Plunge, 2, {{1, 2, 3}, {0, 0, 1}}},
                         {0, 1, Move::Rapid, 0, {{1, 2, 4}, {0, 0, 1}}}}};
    const ToolPath path = test::with_conditions(bare, {{800.5, 6000, 7}, {{}, {}, 7}});
    EXPECT_EQ(
        tool_path_csv(path),
        "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z,tool,patch,"
        "u,v,contact_x_mm,contact_y_mm,contact_z_mm,normal_x,normal_y,normal_z,"
        "feed_mm_per_min,spindle_rpm\n"
        "0,0,plunge,1,2,3,0,0,1,7,2,,,,,,,,,800.5,6000\n"
        "0,1,rapid,1,2,4,0,0,1,7,0,,,,,,,,,,\n");
    EXPECT_THAT(tool_path_csv(test::with_conditions(bare, {{{}, 6000, {}}})),
                testing::HasSubstr(",normal_z,spindle_rpm\n"));
    EXPECT_THAT(tool_path_csv(bare), testing::HasSubstr(",normal_z\n"));
}

TEST(ToolPathCsv, WritesTheLimitOfEachMoveLast)
{
    const ToolPath path =
        test::with_conditions({{{0, 0, Move::Plunge, 0, {{1, 2, 3}, {0, 0, 1}}},
                                {0, 1, Move::Cut, 0, {{1, 5, 3}, {0, 0, 1}}}}},
                              {{800.5, 6000, {}}, {{}, 6000, {}}});
    const std::vector<std::string_view> limits{"", "thrust"};
    const std::string text = tool_path_csv(path, limits);
    EXPECT_THAT(text, testing::HasSubstr(",feed_mm_per_min,spindle_rpm,limit\n"));
    EXPECT_THAT(text, testing::HasSubstr(",800.5,6000,\n"));
    EXPECT_THAT(text, testing::EndsWith(",,6000,thrust\n"));
    EXPECT_THROW(tool_path_csv(path, std::vector<std::string_view>{"cap"}), DomainError);
}

// A normal without the rest of its contact fills the columns of the normal alone.
TEST(ToolPathCsv, WritesANormalAlone)
{
    const ToolPath path{
        {{0, 0, Move::Cut, 0, {{1, 2, 3}, {0, 0, 1}}, Vec3{0.6, 0, 0.8}}}};
    EXPECT_THAT(tool_path_csv(path),
                testing::EndsWith("\n0,0,cut,1,2,3,0,0,1,,,,,,0.6,0,0.8\n"));
}

void expect_vector(const CsvTable& table, std::size_t row,
                   const std::vector<std::string>& columns, const Vec3& expected)
{
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(table.number(row, columns[c]), expected[c]) << row << columns[c];
}

TEST(ToolPathCsv, EveryNumberReadsBackAsTheSameDouble)
{
    const ToolPath path = wavy_path(3, 50);
    const CsvTable table = parse_csv(tool_path_csv(path), "f");
    ASSERT_EQ(table.rows(), path.points.size());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const PathPoint& point = path.points[row];
        EXPECT_EQ(table.number(row, "pass"), point.pass);
        EXPECT_EQ(table.number(row, "point"), point.point);
        EXPECT_EQ(table.cell(row, "move"), move_name(point.move));
        expect_vector(table, row, {"tip_x_mm", "tip_y_mm", "tip_z_mm"},
                      point.location.tip);
        expect_vector(table, row, {"axis_x", "axis_y", "axis_z"}, point.location.axis);
        EXPECT_EQ(table.number(row, "u").has_value(), point.contact() != nullptr);
        if (!point.contact())
            continue;
        EXPECT_EQ(table.number(row, "u"), point.contact()->u);
        EXPECT_EQ(table.number(row, "v"), point.contact()->v);
        expect_vector(table, row, {"contact_x_mm", "contact_y_mm", "contact_z_mm"},
                      point.contact()->contact.point);
        expect_vector(table, row, {"normal_x", "normal_y", "normal_z"},
                      point.contact()->contact.normal);
    }
}

// More points than one batch of runs, so that the joints between batches are tested.
TEST(ToolPathCsv, IsTheSameWithAnyNumberOfThreads)
{
    const ToolPath path = wavy_path(7, 20001);
    set_thread_count(1);
    const std::string alone = tool_path_csv(path);
    set_thread_count(4);
    EXPECT_EQ(tool_path_csv(path), alone);

    std::string line_by_line = tool_path_csv({});
    const std::size_t header = line_by_line.size();
    for (const PathPoint& point : path.points)
        line_by_line += tool_path_csv({{point}}).substr(header);
    EXPECT_EQ(line_by_line, alone);
}

TEST(ToolPathCsv, RefusesANumberThatIsNotFinite)
{
    ToolPath path = wavy_path(2, 5);
    path.points[3].location.tip.y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(tool_path_csv(path), DomainError);
}

TEST(ToolPathCsv, InPiecesIsTheWholeTextWithTheWordsOfAFunction)
{
    ToolPath path;
    for (int i = 0; i < 40'000; ++i)
        path.points.push_back(
            {0, i, Move::Cut, 0, {{0.001 * i, 1.0 / (1 + i), 3}, {0, 0, 1}}});
    std::vector<std::string_view> limits;
    for (std::size_t i = 0; i < path.points.size(); ++i)
        limits.emplace_back(i % 3 == 0 ? "cap" : "");
    std::string text;
    std::size_t pieces = 0;
    write_tool_path_csv(
        path, [&](std::size_t i) { return limits[i]; },
        [&](std::string_view piece) {
            text += piece;
            ++pieces;
        });
    EXPECT_GT(pieces, 10U);
    EXPECT_TRUE(text ==
                tool_path_csv(path, limits));  // not EXPECT_EQ, which would print both
    text.clear();
    write_tool_path_csv(path, [&](std::string_view piece) { text += piece; });
    EXPECT_TRUE(text == tool_path_csv(path));
}

}  // namespace
}  // namespace endmill
