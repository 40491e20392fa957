// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/detail/direction_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

TEST(DirectionCells, OfOnePatchHaveItsAreaAndFourEdges)
{
    const std::vector<DirectionPatch> patches{{-0.3, 1.2, -0.4, 0.9}};
    const DirectionCells cells{patches};
    EXPECT_NEAR(cells.solid_angle(), 1.2 * (std::sin(0.9) + std::sin(0.4)), 1e-15);
    EXPECT_EQ(cells.border().size(), 4U);
}

TEST(DirectionCells, OfNoneAndOfAllDirectionsHaveNoBorder)
{
    const std::vector<DirectionPatch> whole{{1, 2 * pi, -pi / 2, pi / 2}};
    EXPECT_NEAR(DirectionCells{whole}.solid_angle(), 4 * pi, 1e-14);
    EXPECT_TRUE(DirectionCells{whole}.border().empty());
    EXPECT_EQ(DirectionCells{{}}.solid_angle(), 0);
    EXPECT_TRUE(DirectionCells{{}}.border().empty());
}

TEST(DirectionCells, OfACapHaveOneWholeCircle)
{
    const std::vector<DirectionPatch> cap{{2, 2 * pi, 0.5, pi / 2}};
    const auto border = DirectionCells{cap}.border();
    ASSERT_EQ(border.size(), 1U);
    EXPECT_EQ(border[0].to_azimuth - border[0].from_azimuth, 2 * pi);
    EXPECT_EQ(border[0].from_latitude, 0.5);
    EXPECT_EQ(border[0].to_latitude, 0.5);
}

TEST(DirectionCells, OfPatchesThatMeetHaveNoEdgeBetweenThem)
{
    // Two halves of a cap, which meet at azimuth 0 and opposite to it.
    const std::vector<DirectionPatch> halves{{0, pi, 0.5, pi / 2}, {pi, pi, 0.5, pi / 2}};
    EXPECT_EQ(DirectionCells{halves}.border().size(), 1U);
    EXPECT_NEAR(DirectionCells{halves}.solid_angle(), 2 * pi * (1 - std::sin(0.5)),
                1e-14);
    // Two patches, one above the other.
    const std::vector<DirectionPatch> stacked{{0, 1, 0, 0.5}, {0, 1, 0.5, 1}};
    EXPECT_EQ(DirectionCells{stacked}.border().size(), 4U);
}

double distance_round(double angle)
{
    return angle - 2 * pi * std::floor(angle / (2 * pi));
}

// Overlaps count once. The area is compared with the share of random directions in the
// union.
TEST(DirectionCells, HaveTheAreaOfTheUnion)
{
    test::Random random{7};
    for (int k = 0; k < 20; ++k) {
        std::vector<DirectionPatch> patches;
        for (int patch = 0; patch < 3; ++patch) {
            const double low = random.uniform(-pi / 2, pi / 2);
            patches.push_back({random.uniform(-10, 10), random.uniform(0, 2 * pi), low,
                               random.uniform(low, pi / 2)});
        }
        constexpr int samples = 100'000;
        int hits = 0;
        for (int sample = 0; sample < samples; ++sample) {
            const double azimuth = random.uniform(0, 2 * pi);
            const double latitude = std::asin(random.uniform(-1, 1));
            hits += std::ranges::any_of(patches, [&](const DirectionPatch& patch) {
                return distance_round(azimuth - patch.from) <= patch.width &&
                       patch.low <= latitude && latitude <= patch.high;
            });
        }
        const double share = static_cast<double>(hits) / samples;
        const double deviation = std::sqrt(share * (1 - share) / samples);
        EXPECT_NEAR(DirectionCells{patches}.solid_angle() / (4 * pi), share,
                    5 * deviation + 1e-5);
    }
}

}  // namespace
}  // namespace endmill
