// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/guarded_folds.h"

#include <gtest/gtest.h>

#include "endmill/trimming/detail/sequence_trimming.h"

namespace endmill {
namespace {

struct Outcome {
    std::vector<SectionPoint> points;
    std::vector<std::string_view> rules;
    int unresolved;
};

Outcome trim(const std::vector<SectionPoint>& points,
             RunPairs pairs = RunPairs::Neighbours)
{
    const TrimmingOptions guarded;
    SectionChain chain{points, 0};
    Outcome outcome{
        {}, {}, trim_guarded(chain, 0, bound(march_segments, guarded), pairs)};
    for (const TrimmedPoint& point : chain.curve().points)
        outcome.points.push_back(point.at);
    for (const AppliedRule& rule : chain.rules())
        outcome.rules.push_back(rule.rule);
    return outcome;
}

using Rules = std::vector<std::string_view>;
using Points = std::vector<SectionPoint>;

TEST(TrimGuarded, CutsALoopOut)
{
    const Outcome outcome = trim({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});
    EXPECT_EQ(outcome.points, (Points{{-6, 6}, {0, 0}, {6, 6}}));
    EXPECT_EQ(outcome.rules, Rules{"valley"});
    EXPECT_EQ(outcome.unresolved, 0);
}

TEST(TrimGuarded, CutsBackwardEndsOff)
{
    const Outcome end = trim({{-6, 6}, {2, -2}, {0, -1}});
    EXPECT_EQ(end.points, (Points{{-6, 6}, {2, -2}}));
    EXPECT_EQ(end.rules, Rules{"E1"});
    const Outcome start = trim({{0, -1}, {-2, -2}, {6, 6}});
    EXPECT_EQ(start.points, (Points{{-2, -2}, {6, 6}}));
    EXPECT_EQ(start.rules, Rules{"E2"});
}

// The first branch begins right of the second cusp.
TEST(TrimGuarded, CutsABranchOffThatIsTooShort)
{
    const Outcome first = trim({{1, -1.5}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});
    EXPECT_EQ(first.points, (Points{{-2, -2}, {6, 6}}));
    EXPECT_EQ(first.rules, Rules{"E3"});
    const Outcome last = trim({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {-1, -1.5}});
    EXPECT_EQ(last.points, (Points{{-6, 6}, {2, -2}}));
    EXPECT_EQ(last.rules, Rules{"E3"});
}

TEST(TrimGuarded, KeepsTheLongerOfTwoShortBranches)
{
    EXPECT_EQ(trim({{1, -1}, {2, -2}, {-3, -1}, {-1, -3}}).points,
              (Points{{-3, -1}, {-1, -3}}));
    EXPECT_EQ(trim({{1, -1}, {2, -2}, {-3, -1}, {-2, -3}}).points,
              (Points{{1, -1}, {2, -2}}))
        << "of equal ones the first";
}

// A reversal for which there is no crossing and no end rule.
TEST(TrimGuarded, KeepsAndCountsUnresolvedFolds)
{
    const Points overhang{{-4, 4}, {2, 1}, {1, 1.25}, {0, 0.5}, {6, -2.5}};
    const Outcome outcome = trim(overhang);
    EXPECT_EQ(outcome.points, overhang);
    EXPECT_TRUE(outcome.rules.empty());
    EXPECT_EQ(outcome.unresolved, 1);
}

const Points nested{{-10, 10}, {4, -4}, {-2, -3}, {2, -3.5}, {-4, -4}, {10, 10}};

TEST(TrimGuarded, FindsNestedLoopsByAllPairsOnly)
{
    const Outcome neighbours = trim(nested);
    EXPECT_EQ(neighbours.points, nested);
    EXPECT_EQ(neighbours.unresolved, 2);
    const Outcome all = trim(nested, RunPairs::All);
    EXPECT_EQ(all.points, (Points{{-10, 10}, {0, 0}, {10, 10}}));
    EXPECT_EQ(all.unresolved, 0);
}

TEST(TrimGuarded, TrimsARowOfLoops)
{
    Points points;
    constexpr int loops = 200;
    for (int k = 0; k < loops; ++k) {
        const double s = 20 * k;
        for (const SectionPoint& point :
             {SectionPoint{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}})
            points.emplace_back(s + point.x(), point.y());
    }
    for (const RunPairs pairs : {RunPairs::Neighbours, RunPairs::All}) {
        const Outcome outcome = trim(points, pairs);
        EXPECT_EQ(outcome.points.size(), 3U * loops);
        EXPECT_EQ(outcome.unresolved, 0);
        for (std::size_t i = 1; i < outcome.points.size(); ++i)
            EXPECT_GT(outcome.points[i].x(), outcome.points[i - 1].x());
    }
}

}  // namespace
}  // namespace endmill
