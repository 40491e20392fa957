// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_builder.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;

constexpr MoveFeed feed{600};

class ProgramBuilderTest : public testing::Test {
protected:
    ProgramBuilderTest() : lines{"one line", {"f", "E_GCODE"}} { lines.next(); }

    TextLines lines;
    GcodeReadOptions options{.max_extent_mm = 1000, .most_points = 40};
};

std::vector<int> passes(const Program& program)
{
    std::vector<int> found;
    for (const PathPoint& point : program.path.points)
        found.push_back(10 * point.pass + point.point);
    return found;
}

std::vector<int> tools(const Program& program)
{
    std::vector<int> found;
    for (const PathPoint& point : program.path.points)
        found.push_back(point.conditions.tool.value_or(-1));
    return found;
}

std::vector<double> speeds(const Program& program)
{
    std::vector<double> found;
    for (const PathPoint& point : program.path.points)
        found.push_back(point.conditions.spindle_rpm.value_or(-1));
    return found;
}

TEST_F(ProgramBuilderTest, NamesMovesByTheirDirection)
{
    ProgramBuilder builder{lines, options};
    builder.go_to({0, 0, 5}, feed);
    builder.go_to({0, 0, 0}, feed);
    builder.go_to({1, 0, -1}, feed);
    builder.go_to({1, 0, -1}, feed);
    builder.go_to({1, 0, 5}, feed);
    builder.go_to({0, 0, 4}, std::nullopt);
    const Program program = builder.take();
    EXPECT_THAT(moves(program), ElementsAre(Move::Rapid, Move::Plunge, Move::Cut,
                                            Move::Cut, Move::Retract, Move::Rapid));
    EXPECT_THAT(feeds(program),
                ElementsAre(std::nullopt, 600, 600, 600, 600, std::nullopt));
    for (const PathPoint& point : program.path.points)
        EXPECT_EQ(point.location.axis, Vec3::UnitZ());
}

TEST_F(ProgramBuilderTest, BeginsAPassWithTheFirstMoveThatDoesNotCut)
{
    ProgramBuilder builder{lines, options};
    builder.go_to({0, 0, 5}, std::nullopt);
    builder.go_to({0, 0, 0}, feed);
    builder.go_to({1, 0, 0}, feed);
    builder.go_to({2, 0, 0}, feed);
    builder.go_to({2, 0, 5}, feed);
    builder.go_to({3, 0, 5}, std::nullopt);
    builder.go_to({3, 1, 5}, feed);
    builder.go_to({3, 1, 9}, feed);
    EXPECT_THAT(passes(builder.take()), ElementsAre(0, 1, 2, 3, 10, 11, 12, 13));
}

TEST_F(ProgramBuilderTest, MeasuresTheMotionOfTheTip)
{
    options.programmed_point_height_mm = 2;
    ProgramBuilder builder{lines, options};
    builder.go_to({1, 2, 3}, std::nullopt);
    EXPECT_THAT(tips(builder.take()), ElementsAre(Vec3(1, 2, 1)));
}

TEST_F(ProgramBuilderTest, TurnsInverseTimeIntoAFeed)
{
    ProgramBuilder builder{lines, options};
    builder.go_to({0, 0, 0}, std::nullopt);
    builder.go_to({3, 4, 0}, MoveFeed{2, FeedRateMode::InverseTime});
    builder.go_to({3, 4, 0}, MoveFeed{2, FeedRateMode::InverseTime});
    EXPECT_THAT(feeds(builder.take()), ElementsAre(std::nullopt, 10, std::nullopt));
}

TEST_F(ProgramBuilderTest, SharesTheTimeOfAnArcAmongItsChords)
{
    options.most_points = 1000;
    ProgramBuilder builder{lines, options};
    builder.go_to({5, 0, 0}, std::nullopt);
    builder.go_along({{5, 0, 0}, {0, 5, -1}, Vec3::Zero()},
                     MoveFeed{0.25, FeedRateMode::InverseTime});
    const Program program = builder.take();
    const auto& points = program.path.points;
    double minutes = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        minutes += (points[i].location.tip - points[i - 1].location.tip).norm() /
                   program.path.points[i].conditions.feed_mm_per_min.value();
    EXPECT_NEAR(minutes, 4, 1e-12);
    EXPECT_EQ(points.back().location.tip, Vec3(0, 5, -1));
}

TEST_F(ProgramBuilderTest, TurnsTheSpindleBetweenStartAndStop)
{
    ProgramBuilder builder{lines, options};
    const auto step = [&] { builder.go_to({0, 0, 0}, std::nullopt); };
    step();
    builder.set_spindle_speed(3000);
    step();
    builder.stop_spindle();
    step();
    builder.set_spindle_speed(5000);
    step();
    builder.start_spindle(SpindleSense::Clockwise);
    step();
    builder.set_spindle_speed(0);
    step();
    EXPECT_THAT(speeds(builder.take()), ElementsAre(-1, 3000, -1, -1, 5000, -1));
}

// Rapids do not count: the tool cuts nothing on them.
TEST_F(ProgramBuilderTest, KnowsTheFirstMoveAtFeedWithTheSpindleReversed)
{
    const auto built = [&](SpindleSense later) {
        ProgramBuilder builder{lines, options};
        builder.start_spindle(SpindleSense::Counterclockwise);
        builder.go_to({0, 0, 0}, std::nullopt);
        builder.go_to({1, 0, 0}, std::nullopt);
        builder.start_spindle(later);
        builder.go_to({2, 0, 0}, MoveFeed{100});
        builder.go_to({3, 0, 0}, MoveFeed{100});
        return builder.take().counterclockwise_from;
    };
    EXPECT_EQ(built(SpindleSense::Counterclockwise), 2U);
    EXPECT_FALSE(built(SpindleSense::Clockwise));
}

TEST_F(ProgramBuilderTest, ChangesToTheToolSelectedLast)
{
    ProgramBuilder builder{lines, options};
    const auto step = [&] { builder.go_to({0, 0, 0}, std::nullopt); };
    builder.select_tool(1);
    step();
    builder.change_tool();
    builder.select_tool(2);
    step();
    builder.change_tool();
    step();
    builder.change_tool(7);
    step();
    EXPECT_THAT(tools(builder.take()), ElementsAre(-1, 1, 2, 7));
}

TEST_F(ProgramBuilderTest, TreatsASelectionAsAChangeIfThereIsNoChange)
{
    ProgramBuilder builder{lines, options};
    const auto step = [&] { builder.go_to({0, 0, 0}, feed); };
    step();
    builder.select_tool(1);
    step();
    builder.select_tool(1);
    builder.select_tool(2);
    step();
    step();
    const Program program = builder.take();
    EXPECT_THAT(tools(program), ElementsAre(-1, 1, 2, 2));
    EXPECT_THAT(program.remarks, testing::IsEmpty());  // the path states its tools
}

TEST_F(ProgramBuilderTest, HasNoConditionsIfTheProgramStatesNone)
{
    ProgramBuilder builder{lines, options};
    builder.go_to({0, 0, 0}, std::nullopt);
    EXPECT_EQ(builder.take().path.points.at(0).conditions, CuttingConditions{});
}

TEST_F(ProgramBuilderTest, RemarksOnce)
{
    ProgramBuilder builder{lines, options};
    builder.remark("a");
    builder.remark("b");
    builder.remark("a");
    EXPECT_THAT(builder.take().remarks, ElementsAre("a", "b"));
    EXPECT_THAT(builder.take().remarks, ElementsAre());
}

TEST_F(ProgramBuilderTest, RefusesNumbersOutOfRange)
{
    ProgramBuilder builder{lines, options};
    EXPECT_EQ(
        refusal_of([&] {
            builder.go_to({0, -1001, 0}, std::nullopt);
        }),
        "E_RANGE f:1: coordinate -1001 mm; expected at most 1000 mm (--max-extent)");
    builder.go_to({0, 0, 0}, std::nullopt);
    EXPECT_EQ(refusal_of([&] {
                  builder.go_to({10, 0, 0}, MoveFeed{1e308, FeedRateMode::InverseTime});
              }),
              "E_RANGE f:1: a feed of infinite mm/min; expected a feed that a double can "
              "store");
}

TEST_F(ProgramBuilderTest, StopsAtTheMostPoints)
{
    ProgramBuilder builder{lines, options};
    builder.go_to({5, 0, 0}, std::nullopt);
    const Arc arc{{5, 0, 0}, {5, 0, 0}, Vec3::Zero(), ArcPlane::Xy, true, 1e300};
    EXPECT_THAT(refusal_of([&] { builder.go_along(arc, feed); }),
                testing::AllOf(testing::StartsWith("E_LIMIT f:1: an arc of "),
                               testing::EndsWith(" chords makes more than 40 points "
                                                 "(--max-memory, --arc-tolerance)")));
    for (int i = 1; i < 40; ++i)
        builder.go_to({5, 0, 0}, feed);
    EXPECT_EQ(refusal_of([&] {
                  builder.go_to({5, 0, 0}, feed);
              }),
              "E_LIMIT f:1: more than 40 points (--max-memory)");
}

TEST_F(ProgramBuilderTest, ChecksItsOptions)
{
    options.arc_tolerance_mm = -1;
    EXPECT_THROW(ProgramBuilder(lines, options), DomainError);
}

}  // namespace
}  // namespace endmill
