// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/piece_links.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "mixed_pieces.h"

namespace endmill {
namespace {

TEST(PieceLinks, NearestTourLeadsToTheNearestTipEachTime)
{
    const std::vector<PieceEnds> pieces = test::mixed_pieces(1, 40);
    const PieceLinks links{pieces, 10};
    for (const unsigned first : links.possible_starts()) {
        const std::vector<unsigned> starts = links.nearest_tour(first);
        ASSERT_EQ(starts.size(), 40U);
        EXPECT_EQ(starts.front(), first);
        std::vector<bool> is_cut(40);
        for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
            is_cut[links.piece_of(starts[k])] = true;
            const unsigned end = links.end_of(starts[k]);
            double least = std::numeric_limits<double>::infinity();
            for (unsigned piece = 0; piece < 40; ++piece)
                for (unsigned number = 0; number < links.tips(piece); ++number) {
                    const bool ends_here =
                        links.kind(piece) == PieceLinks::Kind::OneWay && number == 1;
                    if (!is_cut[piece] && !ends_here)
                        least = std::min(
                            least, links.cost(end, links.first_tip(piece) + number));
                }
            EXPECT_EQ(links.cost(end, starts[k + 1]), least);
        }
    }
}

TEST(PieceLinks, NearLinksLeadToTheNearestOtherTips)
{
    const std::vector<PieceEnds> pieces = test::mixed_pieces(2, 30);
    const PieceLinks links{pieces, 4};
    for (unsigned piece = 0; piece < 30; ++piece) {
        if (links.kind(piece) == PieceLinks::Kind::Closed)
            continue;
        const unsigned own = links.first_tip(piece);
        const auto near = links.near(own);
        ASSERT_EQ(near.size(), 4U);
        EXPECT_TRUE(std::ranges::is_sorted(near, {}, &PieceLinks::Near::cost));
        // One link each to the ends of open pieces and to closed pieces.
        std::vector<double> costs;
        for (unsigned other = 0; other < 30; ++other) {
            std::vector<double> of_piece;
            for (unsigned k = 0; k < links.tips(other); ++k)
                of_piece.push_back(links.cost(own, links.first_tip(other) + k));
            if (other == piece)
                continue;
            if (links.kind(other) == PieceLinks::Kind::Closed)
                of_piece = {std::ranges::min(of_piece)};
            costs.insert(costs.end(), of_piece.begin(), of_piece.end());
        }
        std::ranges::sort(costs);
        for (std::size_t k = 0; k < near.size(); ++k)
            EXPECT_EQ(near[k].cost, costs[k]);
    }
}

}  // namespace
}  // namespace endmill
