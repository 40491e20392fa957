// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/segment_links.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

CrossedEdge edge(int number)
{
    return {number, -number};
}

// Chains of edges in any order: the successor is the segment that begins where one ends.
TEST(SegmentLinks, FindTheNextSegmentInAnyOrder)
{
    constexpr int count = 5000;
    constexpr int chain = 500;  // number of segments before a gap
    test::Random random{1};
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    SegmentLinks links;
    for (int round = 0; round < 3; ++round) {
        std::vector<CrossedEdge> from;
        std::vector<CrossedEdge> to;
        for (const int k : order) {
            from.push_back(edge(k + k / chain));
            to.push_back(edge(k + k / chain + 1));
        }
        links.link(from, to);
        for (int place = 0; place < count; ++place) {
            const int k = order[place];
            const auto next = links.next(place);
            if ((k + 1) % chain == 0) {
                EXPECT_EQ(next, SegmentLinks::none);
            } else {
                ASSERT_NE(next, SegmentLinks::none);
                EXPECT_EQ(order[next], k + 1);
            }
            EXPECT_EQ(links.is_entered(place), k % chain != 0);
        }
        std::ranges::shuffle(order, random.engine());
    }
}

// Where several segments end or begin on an edge, each is linked to at most one.
TEST(SegmentLinks, LinkNoSegmentTwice)
{
    SegmentLinks links;
    const std::vector from{edge(1), edge(1), edge(2), edge(3), edge(2)};
    const std::vector to{edge(2), edge(2), edge(1), edge(2), edge(4)};
    links.link(from, to);
    std::vector<int> entered(5);
    int linked = 0;
    for (int k = 0; k < 5; ++k)
        if (const auto next = links.next(k); next != SegmentLinks::none) {
            EXPECT_EQ(from[next], to[k]);
            EXPECT_EQ(++entered[next], 1);
            ++linked;
        }
    EXPECT_EQ(linked, 3);
    links.link({}, {});
}

}  // namespace
}  // namespace endmill
