// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/branch_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

RotaryRange range(double from_deg, double to_deg)
{
    return {rad(from_deg), rad(to_deg)};
}

// Positions of C and the tilt for a direction with this azimuth and tilt, in degrees.
SearchPose pose_at(double azimuth_deg, double tilt_deg)
{
    const std::array<RotaryPositions, 2> both{
        RotaryPositions{rad(azimuth_deg), rad(tilt_deg)},
        RotaryPositions{rad(azimuth_deg + 180), rad(-tilt_deg)}};
    return {.arrival = both, .departure = both};
}

// Check [10] of docs/methods/five-axis-paths.md, section 9.
TEST(BranchSearch, ChoosesTheSolutionThatReachesTheEnd)
{
    std::vector<SearchPose> poses;
    for (int azimuth = 0; azimuth <= 300; azimuth += 10)
        poses.push_back(pose_at(azimuth, 30));
    const BranchSearch found =
        search_branches(poses, {range(-200, 200), range(-120, 120)});
    ASSERT_FALSE(found.blocked);
    EXPECT_NEAR(found.choices.front().arrival[0], rad(-180), 1e-12);
    EXPECT_NEAR(found.choices.front().arrival[1], rad(-30), 1e-12);
    EXPECT_NEAR(found.choices.back().arrival[0], rad(120), 1e-12);
    EXPECT_NEAR(found.travel, rad(300), 1e-9);
    EXPECT_EQ(found.retracts, 0U);

    const std::array<RotaryRange, 2> upright{range(-200, 200), range(0, 120)};
    const BranchSearch none = search_branches(poses, upright);
    ASSERT_TRUE(none.blocked);
    EXPECT_EQ(none.blocked->axis, 0U);
    EXPECT_NEAR(none.blocked->limit, rad(200), 1e-12);
    EXPECT_NEAR(none.blocked->position, rad(210), 1e-9);
    for (SearchPose& pose : poses)
        pose.turn = PoseTurn::Retract;
    const BranchSearch lifted = search_branches(poses, upright);
    ASSERT_FALSE(lifted.blocked);
    EXPECT_EQ(lifted.retracts, 1U);
    EXPECT_NEAR(lifted.travel, rad(300 + 360), 1e-9);
}

TEST(BranchSearch, OfAnAxisWithoutLimitsTurnsOnAndOn)
{
    std::vector<SearchPose> poses;
    for (int azimuth = 0; azimuth <= 1000; azimuth += 20)
        poses.push_back(pose_at(azimuth, 30));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const BranchSearch found =
        search_branches(poses, {RotaryRange{-infinity, infinity}, range(-90, 90)});
    ASSERT_FALSE(found.blocked);
    EXPECT_NEAR(found.choices.front().arrival[0], 0, 1e-12);
    EXPECT_NEAR(found.choices.back().arrival[0], rad(1000), 1e-9);
}

// Names the axis and the limit of a pose that is out of reach.
TEST(BranchSearch, NamesTheLeastExcess)
{
    const std::vector<SearchPose> poses{pose_at(0, 10), pose_at(0, 50)};
    const BranchSearch found = search_branches(poses, {range(-30, 30), range(-20, 40)});
    ASSERT_TRUE(found.blocked);
    EXPECT_EQ(found.blocked->pose, 1U);
    EXPECT_EQ(found.blocked->axis, 1U);
    EXPECT_NEAR(found.blocked->position, rad(50), 1e-12);
    EXPECT_NEAR(found.blocked->limit, rad(40), 1e-12);
}

// The best cost by trying all ways.
struct Way {
    int retracts;
    double travel;
    int changes;
};

class Enumeration {
public:
    Enumeration(const std::vector<SearchPose>& poses,
                const std::array<RotaryRange, 2>& ranges)
        : poses_{poses},
          ranges_{ranges}
    {
        for (std::size_t branch = 0; branch < 2; ++branch)
            for (const RotaryPositions& at : copies(poses[0].arrival[branch]))
                go(0, branch, at, {0, 0, 0});
    }

    std::optional<Way> best;

private:
    std::vector<RotaryPositions> copies(const RotaryPositions& at) const
    {
        std::vector<RotaryPositions> all;
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j) {
                const RotaryPositions q{at[0] + i * full_turn, at[1] + j * full_turn};
                if (is_within(q))
                    all.push_back(q);
            }
        return all;
    }

    bool is_within(const RotaryPositions& q) const
    {
        for (std::size_t k = 0; k < 2; ++k)
            if (q[k] < ranges_[k].from - 1e-9 || q[k] > ranges_[k].to + 1e-9)
                return false;
        return true;
    }

    static bool is_better(const Way& first, const Way& second)
    {
        const auto key = [](const Way& way) {
            return std::tuple{way.retracts, std::llround(way.travel * 1e8), way.changes};
        };
        return key(first) < key(second);
    }

    void go(std::size_t pose, std::size_t branch, const RotaryPositions& at, Way way)
    {
        if (pose + 1 == poses_.size()) {
            if (!best || is_better(way, *best))
                best = way;
            return;
        }
        leave(pose, branch, at, way);
        if (poses_[pose].turn == PoseTurn::None)
            return;
        for (std::size_t other = 0; other < 2; ++other)
            for (const RotaryPositions& to : copies(poses_[pose].departure[other])) {
                const double turn = std::abs(to[0] - at[0]) + std::abs(to[1] - at[1]);
                if (turn < 1e-9)
                    continue;
                Way turned = way;
                turned.travel += turn;
                turned.changes += other != branch ? 1 : 0;
                turned.retracts += poses_[pose].turn == PoseTurn::Retract ? 1 : 0;
                leave(pose, other, to, turned);
            }
    }

    void leave(std::size_t pose, std::size_t branch, const RotaryPositions& at, Way way)
    {
        RotaryPositions next = at;
        for (std::size_t k = 0; k < 2; ++k) {
            const double turn = std::remainder(
                poses_[pose + 1].arrival[branch][k] - poses_[pose].departure[branch][k],
                full_turn);
            way.travel += std::abs(turn);
            next[k] += turn;
        }
        if (is_within(next))
            go(pose + 1, branch, next, way);
    }

    const std::vector<SearchPose>& poses_;
    const std::array<RotaryRange, 2>& ranges_;
};

TEST(BranchSearch, FindsTheBestOfAllWays)
{
    test::Random random{11};
    int ways = 0;
    for (int k = 0; k < 200; ++k) {
        std::vector<SearchPose> poses;
        double azimuth = random.uniform(-180, 180);
        double tilt = random.uniform(5, 60);
        for (int i = 0; i < 6; ++i) {
            azimuth += random.uniform(-85, 85);
            tilt = std::clamp(tilt + random.uniform(-20, 20), 2.0, 80.0);
            poses.push_back(pose_at(azimuth, tilt));
            const double kind = random.uniform(0, 1);
            poses.back().turn = kind < 0.2   ? PoseTurn::Free
                                : kind < 0.4 ? PoseTurn::Retract
                                             : PoseTurn::None;
        }
        poses.back().turn = PoseTurn::None;
        const std::array<RotaryRange, 2> ranges{
            range(random.uniform(-250, -20), random.uniform(20, 400)),
            range(random.uniform(-90, 0), random.uniform(20, 90))};
        const BranchSearch found = search_branches(poses, ranges);
        const Enumeration all{poses, ranges};
        ASSERT_EQ(found.blocked.has_value(), !all.best.has_value()) << k;
        if (!all.best)
            continue;
        ++ways;
        EXPECT_EQ(static_cast<int>(found.retracts), all.best->retracts) << k;
        EXPECT_NEAR(found.travel, all.best->travel, 1e-7) << k;
        EXPECT_EQ(static_cast<int>(found.branch_changes), all.best->changes) << k;
    }
    EXPECT_GT(ways, 100);
}

}  // namespace
}  // namespace endmill
