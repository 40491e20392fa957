// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/apt.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "path_conditions.h"
#include "random_path.h"

namespace endmill {
namespace {

TEST(Apt, WritesASmallPathAsByHand)
{
    ToolPath path;
    const Vec3 up = Vec3::UnitZ();
    path.points = {{0, 0, Move::Plunge, 0, {{1, 2, -1}, up}},
                   {0, 1, Move::Cut, 0, {{3.5, 2, -0.00004}, {0.6, 0, 0.8}}},
                   {0, 2, Move::Rapid, 0, {{3.5, 2, 10}, up}},
                   {0, 3, Move::Cut, 0, {{0, 0, 10}, up}}};
    path = test::with_conditions(
        path, {{800, 6000, {}}, {800, 6000, {}}, {{}, 5000, {}}, {250.5, 5000, {}}});
    const WrittenProgram program =
        apt(path, {.name = "a $$ (plate)\n", .cutter = Cutter{6, 1}});
    EXPECT_EQ(program.text,
              "PARTNO/a  plate\n"
              "UNITS/MM\n"
              "CUTTER/12,1\n"
              "SPINDL/6000,RPM,CLW\n"
              "FEDRAT/800,MMPM\n"
              "GOTO/1.0000,2.0000,-1.0000\n"
              "GOTO/3.5000,2.0000,0.0000,0.6,0,0.8\n"
              "SPINDL/5000,RPM,CLW\n"
              "RAPID\n"
              "GOTO/3.5000,2.0000,10.0000\n"
              "FEDRAT/250.5,MMPM\n"
              "GOTO/0.0000,0.0000,10.0000\n"
              "FINI\n");
    EXPECT_EQ(program.lines, 13U);
    EXPECT_DOUBLE_EQ(program.max_rounding_error_mm, 4e-5);
}

TEST(Apt, StatesEachChangeOfTheTool)
{
    const Vec3 up = Vec3::UnitZ();
    ToolPath path;
    path.points = {{0, 0, Move::Cut, 0, {{0, 0, 0}, up}},
                   {0, 1, Move::Cut, 0, {{1, 0, 0}, up}},
                   {0, 2, Move::Cut, 0, {{2, 0, 0}, up}}};
    path = test::with_conditions(path, {{9, {}, 1}, {9, {}, 1}, {9, {}, 2}});
    const std::string text = apt(path, {.decimals = 0}).text;
    EXPECT_EQ(text,
              "PARTNO/\nUNITS/MM\nLOADTL/1\nFEDRAT/9,MMPM\nGOTO/0,0,0\nGOTO/1,0,0\n"
              "LOADTL/2\nGOTO/2,0,0\nFINI\n");
    std::vector<std::optional<int>> tools;
    for (const PathPoint& point : parse_apt(text, "f.apt").path.points)
        tools.push_back(point.conditions.tool);
    EXPECT_EQ(tools, (std::vector<std::optional<int>>{1, 1, 2}));
}

TEST(Apt, LeavesOutTheCutterAndTheSpeedIfUnknown)
{
    const ToolPath path{{{0, 0, Move::Cut, 0, {{0, 0, 0}, {0, 0, 1}}}}};
    EXPECT_EQ(apt(path, {.feed_mm_per_min = 9, .decimals = 0}).text,
              "PARTNO/\nUNITS/MM\nFEDRAT/9,MMPM\nGOTO/0,0,0\nFINI\n");
}

TEST(Apt, RefusesArgumentsOutsideItsDomain)
{
    ToolPath path{{{0, 0, Move::Cut, 0, {{0, 0, 0}, {0, 0, 1}}}}};
    EXPECT_THROW(apt({}, {.feed_mm_per_min = 9}), DomainError);
    EXPECT_THROW(apt(path, {}), DomainError);
    EXPECT_THROW(apt(path, {.feed_mm_per_min = 9, .decimals = 10}), DomainError);
    path.points[0].location.tip.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(apt(path, {.feed_mm_per_min = 9}), DomainError);
}

// A third of a mm has no finite decimal. The written cutter must still read back as the
// same cutter, and a ball as a ball.
TEST(AptRoundTrip, KeepsTheCutterToTheBit)
{
    const ToolPath path{{{0, 0, Move::Cut, 0, {{0, 0, 0}, {0, 0, 1}}}}};
    for (const Cutter& cutter : {Cutter::ball(1.0 / 3), Cutter::ball(7.5),
                                 Cutter::flat(0.1), Cutter{6, 2.0 / 3}}) {
        const std::string text = apt(path, {.cutter = cutter, .feed_mm_per_min = 9}).text;
        EXPECT_EQ(parse_apt(text, "f.apt").cutter, cutter);
    }
}

TEST(AptRoundTrip, KeepsThePathWithinTheRounding)
{
    ToolPath path = test::random_path(21, 2000);
    test::Random random{22};
    for (PathPoint& point : path.points)
        if (random.uniform(0, 1) < 0.5)
            point.location.axis =
                Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 1}.normalized();
    const Program read = parse_apt(apt(path).text, "f.apt");
    EXPECT_TRUE(read.remarks.empty());
    ASSERT_EQ(read.path.points.size(), path.points.size());
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& a = read.path.points[k];
        const PathPoint& b = path.points[k];
        EXPECT_LE((a.location.tip - b.location.tip).lpNorm<Eigen::Infinity>(), 5.0001e-5);
        EXPECT_EQ(a.location.axis, b.location.axis);
        EXPECT_EQ(a.move, b.move);
        const CuttingConditions& conditions = a.conditions;
        EXPECT_NEAR(*conditions.spindle_rpm, *b.conditions.spindle_rpm, 5.0001e-5);
        ASSERT_EQ(conditions.feed_mm_per_min.has_value(), b.move != Move::Rapid);
        if (conditions.feed_mm_per_min) {
            EXPECT_NEAR(*conditions.feed_mm_per_min, *b.conditions.feed_mm_per_min,
                        5.0001e-5);
        }
    }
}

TEST(AptRoundTrip, WritesAReadPathAsTheSameText)
{
    const AptOptions options{.name = "x", .decimals = 3};
    const std::string once = apt(test::random_path(23, 500), options).text;
    EXPECT_EQ(apt(parse_apt(once, "f.apt").path, options).text, once);
}

}  // namespace
}  // namespace endmill
