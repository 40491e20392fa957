// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_chain.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

const std::vector<SectionPoint> row{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};

std::vector<SectionPoint> left(const SectionChain& chain)
{
    std::vector<SectionPoint> points;
    for (const TrimmedPoint& point : chain.curve().points)
        points.push_back(point.at);
    return points;
}

TEST(SectionChain, IsItsInputAtFirst)
{
    const SectionChain chain{row, 7};
    EXPECT_EQ(left(chain), row);
    EXPECT_EQ(chain.next(2), 3);
    EXPECT_EQ(chain.previous(2), 1);
    EXPECT_TRUE(chain.rules().empty());
    for (const TrimmedPoint& point : chain.curve().points)
        EXPECT_EQ(point.on.curve, 7);
}

TEST(SectionChain, JoinsAtACrossing)
{
    SectionChain chain{row, 0};
    const std::int32_t at = chain.join(1, 4, {1, 3, {1.5, 2}}, "P4");
    EXPECT_EQ(chain.at(at), SectionPoint(1.5, 2));
    EXPECT_EQ(left(chain),
              (std::vector<SectionPoint>{{0, 0}, {1, 0}, {1.5, 2}, {4, 0}, {5, 0}}));
    const TrimmedPoint crossing = chain.curve().points[2];
    EXPECT_EQ(crossing.kind, TrimmedKind::Crossing);
    EXPECT_EQ(crossing.on.point, 1);
    EXPECT_EQ(crossing.across.point, 3);
    ASSERT_EQ(chain.rules().size(), 1U);
    EXPECT_EQ(chain.rules()[0].first_point, 2);
    EXPECT_EQ(chain.rules()[0].last_point, 3);
    EXPECT_EQ(chain.rules()[0].rule, "P4");
}

// A segment of a crossing that is bounded by crossings is named by its segment of the
// input.
TEST(SectionChain, NamesTheInputSegmentsOfCrossings)
{
    SectionChain chain{row, 0};
    const std::int32_t first = chain.join(0, 2, {0, 1, {1.2, 1}}, "valley");
    chain.join(first, 5, {first, 4, {3, 3}}, "valley");
    const auto points = chain.curve().points;
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points[1].across.point, 1);
    EXPECT_EQ(points[2].on.point, 1);
    EXPECT_EQ(points[2].across.point, 4);
    EXPECT_EQ(chain.rules()[1].first_point, 2);
    EXPECT_EQ(chain.rules()[1].last_point, 4);
}

TEST(SectionChain, SetsNoSecondPointWhereAVertexIs)
{
    SectionChain at_left{row, 0};
    EXPECT_EQ(at_left.join(1, 4, {1, 3, {1, 0}}, "P4"), 1);
    EXPECT_EQ(left(at_left), (std::vector<SectionPoint>{{0, 0}, {1, 0}, {4, 0}, {5, 0}}));
    SectionChain at_right{row, 0};
    EXPECT_EQ(at_right.join(1, 4, {1, 3, {4, 0}}, "P4"), 4);
    EXPECT_EQ(left(at_right), left(at_left));
}

TEST(SectionChain, LosesItsEnds)
{
    SectionChain chain{row, 0};
    chain.cut_before(2, "E2");
    chain.cut_behind(4, "E1");
    EXPECT_EQ(left(chain), (std::vector<SectionPoint>{{2, 0}, {3, 0}, {4, 0}}));
    ASSERT_EQ(chain.rules().size(), 2U);
    EXPECT_EQ(chain.rules()[0].last_point, 1);
    EXPECT_EQ(chain.rules()[1].first_point, 5);
    chain.cut_before(4, "E2");
    EXPECT_TRUE(left(chain).empty()) << "one point is no curve";
}

TEST(SectionChain, EndsAtACrossingIfCutThere)
{
    SectionChain chain{row, 0};
    const std::int32_t at = chain.join(1, 4, {1, 3, {1.5, 2}}, "P3");
    SectionChain other = chain;
    chain.cut_behind(at, "P3 cut");
    EXPECT_EQ(left(chain), (std::vector<SectionPoint>{{0, 0}, {1, 0}, {1.5, 2}}));
    EXPECT_EQ(chain.rules()[1].first_point, 4);
    other.cut_before(at, "P3 cut");
    EXPECT_EQ(left(other), (std::vector<SectionPoint>{{1.5, 2}, {4, 0}, {5, 0}}));
    EXPECT_EQ(other.rules()[1].last_point, 1);
}

}  // namespace
}  // namespace endmill
