// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/turn_cover.h"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"
#include "random_maps.h"

namespace endmill {
namespace {

// Counts are compared with a loop over cells and cones, for one tile and for several.
TEST(TurnCover, CountsTheFacetsReachedFromEachTurn)
{
    test::Random random{8};
    const SphereGrid grid = sphere_grid("hex:2");
    for (const std::size_t facets : {3U, 200U, 5000U}) {
        const DistinctCones all{test::random_caps(facets, grid.centres, random)};
        std::vector<std::size_t> cones(all.size());
        std::iota(cones.rbegin(), cones.rend(), std::size_t{0});
        std::vector<FeasibleTurns> runs;
        for (std::uint32_t cell = 0; cell < grid.centres.size(); cell += 3)
            runs.push_back({cell, static_cast<std::uint8_t>(random.uniform(0, 72)),
                            static_cast<std::uint8_t>(random.uniform(1, 73))});
        runs.push_back({1, 70, 72});
        const ConeTiles tiles{all, cones};
        std::array<std::size_t, turns_about_tool_axis> counts{};
        TurnCoverScratch scratch;
        for (std::size_t tile = 0; tile < tiles.size(); ++tile)
            tiles.add_reached(tile, runs, counts, scratch);
        for (std::size_t turn = 0; turn < counts.size(); ++turn) {
            std::size_t expected = 0;
            for (const std::size_t cone : cones) {
                bool is_reached = false;
                for (const FeasibleTurns& run : runs)
                    is_reached =
                        is_reached ||
                        (run.hold(turn) &&
                         (all.row(cone)[run.cell / 64] >> (run.cell % 64) & 1) != 0);
                expected += is_reached ? all.facets(cone) : 0;
            }
            EXPECT_EQ(counts[turn], expected) << turn;
        }
    }
}

TEST(TurnCover, HasNoTilesWithoutCones)
{
    EXPECT_EQ(ConeTiles(DistinctCones{VisibilityMap{}}, {}).size(), 0U);
}

}  // namespace
}  // namespace endmill
