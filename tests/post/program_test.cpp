// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/program.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(Program, IsEmptyAndExactByDefault)
{
    const Program program;
    EXPECT_TRUE(program.path.points.empty());
    EXPECT_FALSE(program.cutter);
    EXPECT_TRUE(program.remarks.empty());
    EXPECT_EQ(program.position_error_mm, 0);
}

// Ten characters take one inch, 25.4 mm.
TEST(WrittenProgram, TakesAnInchOfTapeForTenCharacters)
{
    WrittenProgram program;
    program.text = "G1 X1.234\nX2.345 Y6\n";
    EXPECT_DOUBLE_EQ(program.tape_length_m(), 2 * 0.0254);
    EXPECT_EQ(WrittenProgram{}.tape_length_m(), 0);
}

TEST(MinMax, HoldsTheEnds)
{
    MinMax range;
    EXPECT_FALSE(range.least || range.greatest);
    for (const double number : {3.0, -1.0, 7.0, 2.0})
        range.add(number);
    EXPECT_EQ(range.least, -1);
    EXPECT_EQ(range.greatest, 7);
}

using Feeds = std::vector<std::optional<double>>;

// A move at feed to the first point, a cut, a rapid, a plunge, a cut.
ToolPath with_feeds(const Feeds& feeds)
{
    ToolPath path;
    for (const Move move : {Move::Cut, Move::Cut, Move::Rapid, Move::Plunge, Move::Cut}) {
        const std::size_t k = path.points.size();
        path.points.push_back(
            {0, static_cast<int>(k), move, 0, {Vec3::Zero(), Vec3::UnitZ()}});
        path.points.back().conditions.feed_mm_per_min = feeds[k];
    }
    return path;
}

Feeds set(const Feeds& own, const FeedSettings& feeds)
{
    ToolPath path = with_feeds(own);
    set_feeds(path, feeds);
    Feeds found;
    for (const PathPoint& point : path.points)
        found.push_back(point.conditions.feed_mm_per_min);
    return found;
}

const Feeds none{{}, {}, {}, {}, {}};
const Feeds own{500, 600, {}, 50, 700};

TEST(FeedSettings, FillMovesWithoutAFeedAndDescentsWithAShare)
{
    EXPECT_EQ(set(none, {}), none);
    EXPECT_EQ(set(none, {.cutting_mm_per_min = 800}), (Feeds{800, 800, {}, 800, 800}));
    EXPECT_EQ(set(none, {.cutting_mm_per_min = 800, .plunge_share = 0.25}),
              (Feeds{200, 800, {}, 200, 800}));
    EXPECT_EQ(
        set({{}, 600, {}, {}, {}}, {.cutting_mm_per_min = 800, .plunge_share = 0.25}),
        (Feeds{200, 600, {}, 200, 800}));
}

TEST(FeedSettings, KeepThoseOfThePathUnlessReplaced)
{
    EXPECT_EQ(set(own, {.cutting_mm_per_min = 800, .plunge_share = 0.25}), own);
    EXPECT_EQ(set(own, {.cutting_mm_per_min = 800,
                        .choice = FeedChoice::OfSettings,
                        .plunge_share = 0.25}),
              (Feeds{200, 800, {}, 200, 800}));
    EXPECT_EQ(set(own, {.plunge_mm_per_min = 70}), (Feeds{70, 600, {}, 70, 700}));
}

TEST(FeedSettings, RefuseAPlungeFeedAboveTheCuttingFeed)
{
    EXPECT_EQ(set(own, {.plunge_mm_per_min = 700}), (Feeds{700, 600, {}, 700, 700}));
    EXPECT_THROW(set(own, {.plunge_mm_per_min = 701}), DomainError);
    EXPECT_THROW(set(none, {.cutting_mm_per_min = 300, .plunge_mm_per_min = 301}),
                 DomainError);
}

TEST(FeedSettings, RefuseNumbersOutsideTheirDomain)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, nan}) {
        EXPECT_THROW(set(none, {.cutting_mm_per_min = bad}), DomainError);
        EXPECT_THROW(set(none, {.plunge_mm_per_min = bad}), DomainError);
        EXPECT_THROW(set(none, {.plunge_share = bad}), DomainError);
    }
    EXPECT_THROW(set(none, {.plunge_share = 1.01}), DomainError);
}

TEST(ProgramUnit, HasALengthInMm)
{
    EXPECT_EQ(millimetres_per(ProgramUnit::Mm), 1);
    EXPECT_EQ(millimetres_per(ProgramUnit::Inch), 25.4);
}

}  // namespace
}  // namespace endmill
