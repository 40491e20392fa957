// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/wall_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

constexpr float doubt = 1e-5F;

// Closed polygons in the frame of the walls.
std::vector<Eigen::Vector3f> random_corners(test::Random& random, int count)
{
    std::vector<Eigen::Vector3f> corners;
    for (int k = 0; k < count; ++k)
        corners.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1),
                             random.uniform(-1, 1));
    return corners;
}

// All sides of a polygon as walls in a single strip.
std::vector<WallLanes> walls_of(const std::vector<Eigen::Vector3f>& corners)
{
    std::vector<WallLanes> blocks;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::size_t lane = k % float_lanes;
        if (lane == 0) {
            WallLanes& empty = blocks.emplace_back();
            empty.first.fill(8);
            empty.last.fill(-8);
        }
        Eigen::Vector3f a = corners[k];
        Eigen::Vector3f b = corners[(k + 1) % corners.size()];
        WallLanes& walls = blocks.back();
        if (a.x() > b.x())
            std::swap(a, b);
        else
            walls.leaving |= 1U << lane;
        const Eigen::Vector3f slope = (b - a) / (b.x() - a.x());
        walls.first[lane] = a.x();
        walls.last[lane] = b.x();
        walls.along[lane] = a.y();
        walls.along_slope[lane] = slope.y();
        walls.along_doubt[lane] = doubt * (1 + std::abs(slope.y()));
        walls.depth[lane] = a.z();
        walls.depth_slope[lane] = slope.z();
        walls.depth_doubt[lane] = doubt * (1 + std::abs(slope.z()));
    }
    return blocks;
}

// The exits of a ray, side by side in doubles.
int exits_at(const std::vector<Eigen::Vector3f>& corners, const Eigen::Vector3d& start)
{
    int exits = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Eigen::Vector3d a = corners[k].cast<double>();
        const Eigen::Vector3d b = corners[(k + 1) % corners.size()].cast<double>();
        if ((a.x() <= start.x()) == (b.x() <= start.x()))
            continue;
        const Eigen::Vector3d at = a + (start.x() - a.x()) / (b.x() - a.x()) * (b - a);
        if (start.y() > at.y() && start.z() < at.z())
            exits += a.x() < b.x() ? 1 : -1;
    }
    return exits;
}

struct OneStrip {
    std::vector<WallLanes> blocks;
    std::vector<std::uint32_t> begin{0, static_cast<std::uint32_t>(blocks.size())};

    WallStrips strips() const { return {begin, blocks, 0, 0, doubt}; }
};

TEST(WallLanes, CountTheExitsOfRays)
{
    test::Random random{3};
    int decided = 0;
    for (int part = 0; part < 200; ++part) {
        const auto corners = random_corners(random, 3 + part % 20);
        const OneStrip walls{walls_of(corners)};
        PlaceLanes places;
        for (int axis = 0; axis < 3; ++axis)
            for (float& at : places.at[axis])
                at = static_cast<float>(random.uniform(-1, 1));
        // One ray starts exactly beside a corner.
        places.at[0][3] = corners[0].x();
        const unsigned asked = part % 2 == 0 ? 0xFFU : 0x5BU;
        const ExitLanes found =
            ray_exits(walls.strips(), places, Eigen::Matrix3f::Identity(), asked);
        EXPECT_EQ((found.none | found.some) & ~asked, 0U);
        EXPECT_EQ(found.none & found.some, 0U);
        for (int lane = 0; lane < float_lanes; ++lane) {
            const int exits = exits_at(corners, places.place(lane).cast<double>());
            EXPECT_EQ(((exits == 0 ? found.some : found.none) >> lane & 1U), 0U);
            decided += static_cast<int>((found.none | found.some) >> lane & 1U);
        }
    }
    EXPECT_GT(decided, 1200);
}

TEST(WallLanes, GiveABoxTheExitsOfAllItsRays)
{
    test::Random random{4};
    int decided = 0;
    int met = 0;
    for (int part = 0; part < 2000; ++part) {
        const auto corners = random_corners(random, 3 + part % 20);
        const OneStrip walls{walls_of(corners)};
        Eigen::Vector3f low = random_corners(random, 1)[0];
        const Eigen::Vector3f size = 0.1F * random_corners(random, 1)[0].cwiseAbs();
        const std::optional<int> exits =
            box_exits(walls.strips(), ProjectedBox{low, low + size});
        if (!exits)
            continue;
        ++decided;
        met += *exits != 0;
        for (int k = 0; k < 10; ++k) {
            const Eigen::Vector3d share{random.uniform(0, 1), random.uniform(0, 1),
                                        random.uniform(0, 1)};
            EXPECT_EQ(*exits,
                      exits_at(corners, low.cast<double>() +
                                            share.cwiseProduct(size.cast<double>())));
        }
    }
    EXPECT_GT(decided, 500);
    EXPECT_GT(met, 50);
}

// The frame is applied to the places, and lanes without a wall count for nothing.
TEST(WallLanes, MapPlacesToTheirFrame)
{
    const std::vector<Eigen::Vector3f> corners{{-0.5F, 0, 0}, {0.5F, 0.1F, 0.2F}};
    std::vector<WallLanes> blocks = walls_of(corners);
    blocks[0].first[1] = 8;  // only the first side is left
    blocks[0].last[1] = -8;
    const OneStrip walls{blocks};
    PlaceLanes places;
    places.at[0].fill(0.5F);  // along
    places.at[1].fill(0.1F);  // across
    places.at[2].fill(-0.5F);
    places.at[0][2] = -0.5F;
    Eigen::Matrix3f frame;
    frame << 0, 1, 0, 1, 0, 0, 0, 0, 1;
    const ExitLanes found = ray_exits(walls.strips(), places, frame, 0xFFU);
    EXPECT_EQ(found.some, 0xFBU);
    EXPECT_EQ(found.none, 0x04U);
}

}  // namespace
}  // namespace endmill
