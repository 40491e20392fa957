// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/apt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "path_conditions.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const std::string& text, const AptReadOptions& options = {})
{
    try {
        parse_apt(text, "f.apt", options);
        return "accepted";
    } catch (const Error& error) {
        return error.code() + ' ' + error.what();
    }
}

TEST(AptReader, ReadsEveryStatement)
{
    const Program program = parse_apt(
        "PARTNO bracket 7, first side\r\n"
        "$$ made by hand\r\n"
        "REMARK/ GOTO/9,9,9 is text\r\n"
        "PPRINT FEDRAT/1\r\n"
        "units / mm\r\n"
        "CUTTER/10,5\r\n"
        "LOADTL/3,LENGTH,100\r\nCOOLNT/ON\r\nSTOP\r\n"
        "\r\n"
        "RAPID\r\n"
        "GOTO/0,0,10 $$ above\r\n"
        "  SPINDL/ 3000 , RPM , CLW\r\n"
        "FEDRAT/250.5,MMPM\r\n"
        "goto/0,0,-1.5\r\n"
        "GOTO/+5,.5,-1.5,0,0.6,0.8\r\n"
        "RAPID\r\n"
        "GOTO/5,.5,10\r\n"
        "GOTO/5,.5,12\r\n"
        "FINI\r\n",
        "f.apt");
    const auto& points = program.path.points;
    ASSERT_EQ(points.size(), 5U);
    EXPECT_EQ(program.cutter, Cutter::ball(5));
    EXPECT_TRUE(program.remarks.empty());
    std::vector<Move> moves;
    moves.reserve(points.size());
    for (const PathPoint& point : points)
        moves.push_back(point.move);
    EXPECT_THAT(moves, ElementsAre(Move::Rapid, Move::Plunge, Move::Cut, Move::Rapid,
                                   Move::Retract));
    EXPECT_EQ(points[2].location.tip, (Vec3{5, 0.5, -1.5}));
    EXPECT_EQ(points[2].location.axis, (Vec3{0, 0.6, 0.8}));
    EXPECT_EQ(points[3].location.axis, (Vec3{0, 0, 1}));
    EXPECT_THAT(
        test::conditions_of(program.path),
        ElementsAre(CuttingConditions{{}, {}, 3}, CuttingConditions{250.5, 3000, 3},
                    CuttingConditions{250.5, 3000, 3}, CuttingConditions{{}, 3000, 3},
                    CuttingConditions{250.5, 3000, 3}));
}

TEST(AptReader, RequiresOnlyAGoto)
{
    const Program program = parse_apt("\xef\xbb\xbfGOTO/1,2,3", "f.apt");
    EXPECT_EQ(program.path.points.size(), 1U);
    EXPECT_EQ(program.path.points[0].move, Move::Plunge);
    EXPECT_FALSE(program.cutter);
    EXPECT_EQ(program.path.points[0].conditions, CuttingConditions{});
    EXPECT_THAT(program.remarks,
                ElementsAre(HasSubstr("taken as mm"), HasSubstr("no FINI")));
}

TEST(AptReader, IgnoresTextAfterTheEnd)
{
    const Program program =
        parse_apt("UNITS/MM\nGOTO/1,2,3\nFINI\n\nGOTO/4,5,6\n", "f.apt");
    EXPECT_EQ(program.path.points.size(), 1U);
    EXPECT_THAT(program.remarks, ElementsAre("text after FINI is ignored"));
}

TEST(AptReader, ReadsACutterWithoutACornerAsFlat)
{
    EXPECT_EQ(parse_apt("CUTTER/8\nGOTO/1,2,3", "f").cutter, Cutter::flat(4));
}

TEST(AptReader, RefusesOtherStatementsWithTheLine)
{
    for (const char* statement : {"FROM/0,0,0",
                                  "GODLTA/1,2,3",
                                  "CIRCLE/1,2,3",
                                  "GOTO",
                                  "GO TO/1,2,3",
                                  "X1 Y2",
                                  "GOTO/1,2,3 $",
                                  "GOTO/1,2 $ 3",
                                  "GOTO/1,2$\n3",
                                  "$",
                                  "END",
                                  "/1,2",
                                  "RAPID/1",
                                  "RAPID GOTO/1,2,3",
                                  "FINI/1",
                                  "%",
                                  "UNITS/INCH",
                                  "UNITS",
                                  "SPINDL/ON",
                                  "SPINDL",
                                  "SPINDL/",
                                  "SPINDL/RPM,CLW",
                                  "SPINDL/100,100",
                                  "SPINDL/100,RPM,RPM",
                                  "SPINDL/100,CLW,CLW",
                                  "SPINDL/100,SFM",
                                  "SPINDL/100,RPM,CLW,RANGE,2",
                                  "SPINDL/OFF,CLW",
                                  "LOADTL",
                                  "LOADTL/drill",
                                  "LOADTL/1.5",
                                  "LOADTL/-1",
                                  "LOADTL/100000",
                                  "SPINDL/100,RPM,CCLW",
                                  "SPINDL/0,RPM,CLW",
                                  "SPINDL/-1,RPM,CLW",
                                  "FEDRAT/10",
                                  "FEDRAT/10,IPM",
                                  "FEDRAT/0,MMPM",
                                  "FEDRAT/-5,MMPM",
                                  "FEDRAT/,MMPM",
                                  "CUTTER/0",
                                  "CUTTER/10,6",
                                  "CUTTER/10,-1",
                                  "CUTTER/10,5,1",
                                  "CUTTER/"})
        EXPECT_THAT(refusal(std::string{"UNITS/MM\n"} + statement + "\nGOTO/0,0,0\nFINI"),
                    testing::StartsWith("E_APT f.apt:2: "))
            << statement;
}

// MULTAX announces axes; a GOTO without one has +z.
TEST(AptReader, ReadsMultaxWithItsAxes)
{
    const std::string start = "UNITS/MM\nMULTAX\nGOTO/1,2,3,0,0,1\n";
    const Program program = parse_apt(start + "GOTO/4,5,6\nMULTAX/OFF\nFINI", "f.apt");
    ASSERT_EQ(program.path.points.size(), 2U);
    EXPECT_EQ(program.path.points[0].location.axis, Vec3::UnitZ());
    const Program tilted = parse_apt(start + "GOTO/4,5,6,0.6,0,0.8\nFINI", "f.apt");
    EXPECT_EQ(tilted.path.points[1].location.axis, Vec3(0.6, 0, 0.8));
    EXPECT_EQ(refusal("MULTAX/ON\nGOTO/1,2,3,0,0,1\nFINI"), "accepted");
    for (const std::string statement : {"MULTAX/3", "MULTAX ON", "MULTAX/ON,1"})
        EXPECT_EQ(refusal(statement + "\nGOTO/1,2,3"),
                  "E_APT f.apt:1: \"" + statement +
                      "\"; expected MULTAX, MULTAX/ON or MULTAX/OFF");
}

TEST(AptReader, RefusesBadPoints)
{
    for (const char* numbers :
         {"", "1,2", "1,2,3,4", "1,2,3,0,0", "1,2,3,0,0,1,0", "1,,3", "1,2,nan",
          "1,2,inf", "1,2,1e3", "1,2,3;", "1,2,#1", "a,b,c", "1 2 3", "1,2,3,0,0,0",
          "1,2,3,0,0,1.01", "1,2,3,0,0,nan"})
        EXPECT_THAT(refusal(std::string{"GOTO/0,0,0\nGOTO/"} + numbers),
                    testing::StartsWith("E_APT f.apt:2: "))
            << numbers;
    EXPECT_THAT(refusal("GOTO/1,2,1000001"), HasSubstr("E_RANGE f.apt:1: coordinate"));
    EXPECT_EQ(refusal("GOTO/1,2,1000001", {.max_extent_mm = 2e6}), "accepted");
}

// The same statements, on a line each and over several lines.
TEST(AptReader, JoinsLinesThatEndWithADollar)
{
    const std::string around = "UNITS/MM\nCUTTER/10,5\n*SPINDL/900,RPM,CLW\n*FINI\n";
    const auto points = [&](const std::string& statement) {
        std::string text = around;
        text.replace(text.rfind('*'), 1, statement + "\n");
        text.replace(text.find('*'), 1, "");
        std::vector<std::pair<Vec3, Vec3>> found;
        for (const PathPoint& point : parse_apt(text, "f.apt").path.points)
            found.emplace_back(point.location.tip, point.location.axis);
        return found;
    };
    const auto expected = points("GOTO/1,-2.5,3,0,0.6,0.8\nGOTO/4,5,6");
    for (const std::string statement :
         {"GOTO/1,-2.5,3,$\n0,0.6,0.8\nGOTO/4,5,6",
          "GOTO$\n/1,-2.5$ $$ comment\r\n,3,0,0.6, $  \r\n$\n0.8\nGOTO/4,$\n5,6",
          "REMARK costs 5 $\nGOTO/1,-2.5,3,0,0.6,0.8\nPPRINT $\nGOTO/4,5,6"})
        EXPECT_EQ(points(statement), expected) << statement;
    EXPECT_EQ(refusal("UNITS/MM\nGOTO/1,$\n\n2,$\nnone\nFINI"),
              "E_APT f.apt:2: \"GOTO/1,\"; expected GOTO/x,y,z or GOTO/x,y,z,i,j,k");
    EXPECT_EQ(
        refusal("UNITS/MM\nGOTO/1,$\n2,$"),
        "E_APT f.apt:2: a $ in the last line; expected the rest of the statement in "
        "another line");
    std::string endless = "UNITS/MM\nGOTO/1";
    for (int k = 0; k < 1100; ++k)
        endless += std::string(1000, '0') + "$\n";
    EXPECT_THAT(refusal(endless), HasSubstr("E_LIMIT f.apt:2: a statement is longer"));
}

TEST(AptReader, ReadsTheFormsOfSpindl)
{
    const auto speed = [](const std::string& statements) {
        return parse_apt(statements + "\nGOTO/1,2,3", "f")
            .path.points.front()
            .conditions.spindle_rpm;
    };
    for (const std::string words :
         {"900,RPM,CLW", "900,CLW", "900,CLW,RPM", "RPM,900,CLW", "rpm, 900.0", "900"})
        EXPECT_EQ(speed("SPINDL/" + words), 900) << words;
    EXPECT_EQ(speed("SPINDL/900\nSPINDL/OFF"), std::nullopt);
    EXPECT_EQ(speed("SPINDL/900\nSPINDL/OFF\nSPINDL/ON"), 900);
}

TEST(AptReader, AllowsSeveralCuttersBesideAToolTable)
{
    const std::string text =
        "LOADTL/1\nCUTTER/10,5\nGOTO/1,2,3\nLOADTL/2\nCUTTER/8\nGOTO/1,2,3";
    EXPECT_EQ(refusal(text, {.several_cutters = true}), "accepted");
    EXPECT_FALSE(parse_apt(text, "f", {.several_cutters = true}).cutter);
    EXPECT_EQ(refusal("CUTTER/10,5\nLOADTL/1\nGOTO/1,2,3\nLOADTL/2\nRAPID\nGOTO/1,2,9\n"
                      "CUTTER/8\nGOTO/1,2,3\nCUTTER/10,5\nRAPID\nGOTO/1,2,9\nLOADTL/1\n"
                      "GOTO/1,2,3",
                      {.several_cutters = true}),
              "accepted");
    EXPECT_EQ(
        refusal("CUTTER/10,5\nGOTO/1,2,3\nCUTTER/8\nGOTO/1,2,4",
                {.several_cutters = true}),
        "E_APT f.apt:4: another CUTTER without a tool number, flat:8 after ball:10; "
        "expected LOADTL with another number before it");
    EXPECT_THAT(
        refusal(text + "\nLOADTL/1\nCUTTER/8\nGOTO/1,2,4", {.several_cutters = true}),
        HasSubstr("f.apt:9: another CUTTER for tool 1, flat:8 after ball:10"));
    EXPECT_EQ(parse_apt("CUTTER/8\nGOTO/1,2,3", "f", {.several_cutters = true}).cutter,
              Cutter::flat(4));
}

TEST(AptReader, RefusesTwoCuttersAndNoPath)
{
    EXPECT_EQ(refusal("CUTTER/10,5\nCUTTER/10,5\nCUTTER/8\nGOTO/1,2,3"),
              "E_APT f.apt:3: \"CUTTER/8\"; expected one cutter for the whole path, or "
              "--tools FILE, a table with the cutter of each tool");
    EXPECT_THAT(refusal("UNITS/MM\nFINI\n"), HasSubstr("E_APT f.apt: no GOTO"));
    EXPECT_THAT(refusal(" \n"), HasSubstr("E_EMPTY"));
}

TEST(AptReader, KeepsItsLimits)
{
    EXPECT_THAT(refusal("GOTO/1,2,3\nGOTO/1,2,4\n", {.most_points = 1}),
                HasSubstr("E_LIMIT f.apt: more than 1 points"));
    EXPECT_THAT(refusal("UNITS/MM\nREMARK" + std::string(1 << 20, ' ') + "\n"),
                HasSubstr("E_LIMIT f.apt:2: line is longer than 1 MiB"));
}

TEST(AptReader, RecognisesAptByTheFirstStatement)
{
    for (const char* text : {"PARTNO x\n", "\xef\xbb\xbf\n $$ c\n GOTO/1,2,3", "units/mm",
                             "CUTTER/10", "RAPID\n", "PPRINT/x"})
        EXPECT_TRUE(is_apt(text)) << text;
    for (const char* text : {"", "\n", "%\n", "G1 X1", "GOTOX/1", "pass,point,move",
                             "    1 N..... COMMENT(\"x\")", "solid x", "$$ only"})
        EXPECT_FALSE(is_apt(text)) << text;
}

}  // namespace
}  // namespace endmill
