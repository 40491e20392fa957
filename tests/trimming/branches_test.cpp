// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/branches.h"

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// A loop that crosses itself in the origin. A is its first segment, B its last.
const std::vector<SectionPoint> loop{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}};
constexpr Branches of_loop{0, 1, 3, 4};

TEST(CrossingOf, IsWhereTheSegmentsCross)
{
    const SectionChain chain{loop, 0};
    const auto crossing = crossing_of(chain, 0, 3, CrossingType::Valley);
    ASSERT_TRUE(crossing);
    EXPECT_EQ(crossing->at, SectionPoint(0, 0));
    EXPECT_FALSE(crossing_of(chain, 0, 2, CrossingType::Any));
}

TEST(CrossingOf, DependsOnTheTurnOfThePath)
{
    // The loop of a hill, at whose crossing the path turns right.
    const std::vector<SectionPoint> hill{{-6, -6}, {2, 2}, {0, 1}, {-2, 2}, {6, -6}};
    const SectionChain chain{hill, 0};
    EXPECT_TRUE(crossing_of(chain, 0, 3, CrossingType::Any));
    EXPECT_FALSE(crossing_of(chain, 0, 3, CrossingType::Valley));
}

TEST(CrossingOf, CountsATouchOnceOrNever)
{
    // A vertex of B at the origin lies on A; the next segment of B crosses A.
    const std::vector<SectionPoint> touching{{-4, 4}, {4, -4}, {-3, -3}, {0, 0}, {5, 5}};
    const SectionChain chain{touching, 0};
    EXPECT_FALSE(crossing_of(chain, 0, 2, CrossingType::Any));
    EXPECT_TRUE(crossing_of(chain, 0, 3, CrossingType::Any));
}

TEST(CrossingOf, IsNoneOfParallelSegments)
{
    const std::vector<SectionPoint> parallel{{0, 0}, {4, 0}, {3, 1}, {1, 0}, {6, 0}};
    const SectionChain chain{parallel, 0};
    EXPECT_FALSE(crossing_of(chain, 0, 3, CrossingType::Any));
}

TEST(CrossingOf, LiesInBothBoxes)
{
    test::Random random{5};
    int found = 0;
    for (int k = 0; k < 3000; ++k) {
        // Nearly parallel segments, for which the quotient of the crossing loses all
        // digits.
        const double tilt = random.uniform(-1e-14, 1e-14);
        const std::vector<SectionPoint> points{
            {0, 0}, {1, 1.0 / 3}, {0, 1}, {0.25, 0.25 / 3 + tilt}, {0.75, 0.25 - tilt}};
        const SectionChain chain{points, 0};
        if (const auto crossing = crossing_of(chain, 0, 3, CrossingType::Any)) {
            ++found;
            EXPECT_GE(crossing->at.x(), 0.25);
            EXPECT_LE(crossing->at.x(), 0.75);
        }
    }
    EXPECT_GT(found, 1000);
}

TEST(FirstMeeting, IsTheNearestToTheCusp)
{
    const SectionChain chain{loop, 0};
    const auto on_a = first_meeting_of_a(chain, of_loop, 0, -2);
    ASSERT_TRUE(on_a);
    EXPECT_EQ(on_a->segment, 0);
    EXPECT_DOUBLE_EQ(on_a->other, 2);
    const auto on_b = first_meeting_of_b(chain, of_loop, 1, 3);
    ASSERT_TRUE(on_b);
    EXPECT_EQ(on_b->segment, 3);
    EXPECT_DOUBLE_EQ(on_b->other, 3);
    EXPECT_FALSE(first_meeting_of_b(chain, of_loop, 1, 7));
}

// Each height between the ends belongs to exactly one segment, the heights of vertices
// included.
TEST(FirstMeeting, IsHalfOpen)
{
    const std::vector<SectionPoint> points{{0, 4}, {1, 2}, {2, 2}, {3, 0}, {4, 3}};
    const SectionChain chain{points, 0};
    const Branches branches{0, 3, 3, 4};
    EXPECT_EQ(first_meeting_of_a(chain, branches, 1, 2)->segment, 0);
    EXPECT_FALSE(first_meeting_of_a(chain, branches, 1, 4));
    EXPECT_EQ(first_meeting_of_a(chain, branches, 1, 0)->segment, 2);
}

TEST(FirstCrossed, IsTheNearestToTheCuspThatALineCrosses)
{
    const SectionChain chain{loop, 0};
    EXPECT_EQ(first_crossed_of_a(chain, of_loop, 3), 0);
    EXPECT_EQ(first_crossed_of_b(chain, of_loop, 0), 3);
    EXPECT_FALSE(first_crossed_of_a(chain, of_loop, 0)) << "it lies on its line";
}

}  // namespace
}  // namespace endmill
