// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/literal_folds.h"

#include <gtest/gtest.h>

#include "endmill/trimming/detail/sequence_trimming.h"

namespace endmill {
namespace {

// The points of the result and the words of the rules.
struct Outcome {
    std::vector<SectionPoint> points;
    std::vector<std::string_view> rules;
};

Outcome trim(const std::vector<SectionPoint>& points)
{
    SectionChain chain{points, 0};
    const TrimmingOptions literal{.detection = FoldDetection::Literal};
    trim_literally(chain, 0, bound(scan_segments, literal), literal.patterns);
    Outcome outcome;
    for (const TrimmedPoint& point : chain.curve().points)
        outcome.points.push_back(point.at);
    for (const AppliedRule& rule : chain.rules())
        outcome.rules.push_back(rule.rule);
    return outcome;
}

TEST(TrimLiterally, FindsALoopByP4)
{
    const Outcome outcome = trim({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});
    EXPECT_EQ(outcome.points, (std::vector<SectionPoint>{{-6, 6}, {0, 0}, {6, 6}}));
    EXPECT_EQ(outcome.rules, std::vector<std::string_view>{"P4"});
}

TEST(TrimLiterally, FindsATiltedLoopByP3)
{
    const Outcome outcome =
        trim({{-4, -1}, {2, 1}, {1, 0.25}, {-0.5, -2}, {2, 4}, {3, 7}});
    EXPECT_EQ(outcome.points.size(), 4U);
    EXPECT_EQ(outcome.rules, std::vector<std::string_view>{"P3"});
}

// The result is the part in front of the first change of sign, or the part behind the
// last.
TEST(TrimLiterally, CutsOffTheShorterPartWhereNothingCrosses)
{
    const Outcome front = trim({{-4, 2}, {-2, 0}, {0, 1}, {2, 0}, {3, 2}});
    EXPECT_EQ(front.points, (std::vector<SectionPoint>{{-4, 2}, {-2, 0}}));
    EXPECT_EQ(front.rules, std::vector<std::string_view>{"P4 cut"});
    const Outcome behind = trim({{0, 0}, {1, 2}, {2, 1}, {4, 3}});
    EXPECT_EQ(behind.points, (std::vector<SectionPoint>{{2, 1}, {4, 3}}));
    EXPECT_EQ(behind.rules, std::vector<std::string_view>{"P3 cut"});
}

TEST(TrimLiterally, GoesOnBehindACut)
{
    // P3 without a crossing, then a loop found by P3 from the third run on.
    const Outcome outcome = trim(
        {{-9, 0}, {-8, 2}, {-7, -3}, {2, 1}, {1, 0.25}, {-0.5, -2}, {2, 4}, {30, 7}});
    EXPECT_EQ(outcome.points.front(), SectionPoint(-7, -3));
    EXPECT_EQ(outcome.rules, (std::vector<std::string_view>{"P3 cut", "P3"}));
}

TEST(TrimLiterally, KeepsCurvesWithFewerRuns)
{
    for (const std::vector<SectionPoint>& points :
         {std::vector<SectionPoint>{{0, 0}, {1, 0}},
          {{0, 2}, {1, 0}, {2, 2}},
          {{0, 2}, {1, 0}, {2, 2}, {3, 0}}}) {
        EXPECT_EQ(trim(points).points, points);
    }
}

}  // namespace
}  // namespace endmill
