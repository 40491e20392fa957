// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/helical_edge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

bool has(const std::vector<EdgeRange>& ranges, double height)
{
    return std::any_of(ranges.begin(), ranges.end(), [&](const EdgeRange& range) {
        return height > range.from && height < range.to;
    });
}

// Whether a point of the edge is in the material, on the ball or the shank.
bool cuts(const BallEngagement& e, double helix, double turn, double height)
{
    const double azimuth = turn - height * std::tan(helix);
    if (height <= 1)
        return is_engaged(e, std::acos(1 - height), azimuth);
    const double once = azimuth - 2 * pi * std::floor(azimuth / (2 * pi));
    return height < e.depth_ratio && once < shank_angle(e);
}

TEST(HelicalEdge, IsEngagedWhereItsPointsAre)
{
    test::Random random{21};
    constexpr int looks = 200;
    int wrong = 0;
    int looked = 0;
    for (int n = 0; n < 1500; ++n) {
        BallEngagement e{random.uniform(-1.3, 1.3), random.uniform(-1.2, 1.2),
                         random.uniform(0.02, 1.5), random.uniform(0.1, 3)};
        if (n % 4 == 0)
            e.previous = n % 8 == 0 ? PreviousPass::None : PreviousPass::Edge;
        if (n % 3 == 0)
            e.lambda = 0;
        const double helix = n % 7 == 0 ? 0 : random.uniform(-1, 1.2);
        const HelicalEdge edge{e, helix};
        const double turn = random.uniform(-7, 7);
        const auto ranges = edge.engaged(turn);
        const double top = std::max(1.0, e.depth_ratio);
        for (int k = 0; k < looks; ++k) {
            const double height = top * (k + 0.41) / looks;
            ++looked;
            wrong += has(ranges, height) != cuts(e, helix, turn, height) ? 1 : 0;
        }
        for (std::size_t k = 1; k < ranges.size(); ++k)
            EXPECT_LE(ranges[k - 1].to, ranges[k].from);
    }
    EXPECT_EQ(wrong, 0) << "of " << looked;
}

// The number of ranges is constant between events.
TEST(HelicalEdge, ChangesAtItsEventsOnly)
{
    test::Random random{22};
    for (int n = 0; n < 60; ++n) {
        const BallEngagement e{random.uniform(-1.2, 1.2), random.uniform(-1, 1),
                               random.uniform(0.05, 1), random.uniform(0.2, 2)};
        const HelicalEdge edge{e, 0.5};
        const std::vector<double>& events = edge.events();
        if (events.empty())  // the previous pass has removed everything
            continue;
        EXPECT_TRUE(std::is_sorted(events.begin(), events.end()));
        EXPECT_GE(events.front(), 0);
        EXPECT_LT(events.back(), 2 * pi);
        for (std::size_t k = 1; k < events.size(); ++k) {
            if (events[k] - events[k - 1] < 1e-6)
                continue;
            const auto count = [&](double share) {
                const double turn = events[k - 1] + share * (events[k] - events[k - 1]);
                return edge.engaged(turn).size();
            };
            for (const double share : {0.001, 0.3, 0.7, 0.999})
                EXPECT_EQ(count(share), count(0.5)) << n << ' ' << events[k];
        }
    }
}

TEST(HelicalEdge, OfASlotWithoutHelixIsEngagedInFront)
{
    const HelicalEdge edge{{0, 0, 0, 2, PreviousPass::None}, 0};
    const auto ranges = edge.engaged(1);
    ASSERT_EQ(ranges.size(), 2U);
    EXPECT_EQ(ranges[0].from, 0);
    EXPECT_EQ(ranges[0].to, 1);
    EXPECT_EQ(ranges[1].to, 2);
    EXPECT_TRUE(edge.engaged(4).empty());
}

TEST(HelicalEdge, InAirIsNotEngaged)
{
    EXPECT_TRUE(HelicalEdge({0, 0, 0, 1}, 0.5).engaged(1).empty());
    EXPECT_TRUE(HelicalEdge({0, 0, 0.5, -2}, 0.5).engaged(1).empty());
    EXPECT_TRUE(HelicalEdge({0, 0, 0.5, -2}, 0.5).events().empty());
}

TEST(HelicalEdge, RefusesSteepHelicesAndManyWindings)
{
    EXPECT_THROW(HelicalEdge({0, 0, 0.5, 1}, 1.6), DomainError);
    EXPECT_THROW(HelicalEdge({0, 0, 0.5, 1e9}, 0.5), DomainError);
    EXPECT_THROW(HelicalEdge({2, 0, 0.5, 1}, 0.5), DomainError);
    EXPECT_NO_THROW(HelicalEdge({0, 0, 0.5, 1e9}, 0));
}

}  // namespace
}  // namespace endmill
