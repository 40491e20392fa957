// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/piece_tour.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "mixed_pieces.h"

namespace endmill {
namespace {

// Without a gain left, no two pieces may be exchanged and none may be turned for a gain.
TEST(PieceTour, ImprovesUntilNoPieceIsBetterElsewhere)
{
    const std::vector<PieceEnds> pieces = test::mixed_pieces(3, 25);
    const PieceLinks links{pieces, 100};  // all neighbours
    PieceTour tour{links, links.nearest_tour(0)};
    const double before = tour.cost();
    tour.improve();
    EXPECT_LE(tour.cost(), before);
    const std::vector<unsigned> starts = tour.starts();
    for (std::size_t from = 0; from < starts.size(); ++from)
        for (std::size_t to = 0; to < starts.size(); ++to) {
            std::vector<unsigned> changed = starts;
            const unsigned moved = changed[from];
            changed.erase(changed.begin() + std::ptrdiff_t(from));
            changed.insert(changed.begin() + std::ptrdiff_t(to), moved);
            EXPECT_GE((PieceTour{links, changed}.cost()), tour.cost() * (1 - 1e-9));
            if (links.kind(links.piece_of(moved)) != PieceLinks::Kind::Reversible)
                continue;
            changed[to] = links.end_of(moved);
            EXPECT_GE((PieceTour{links, changed}.cost()), tour.cost() * (1 - 1e-9));
        }
}

TEST(PieceTour, KeepsEachPieceAndTheDirectionOfOneWayPieces)
{
    for (unsigned seed = 10; seed < 40; ++seed) {
        const std::vector<PieceEnds> pieces = test::mixed_pieces(seed, 3 + seed);
        const PieceLinks links{pieces, 10};
        PieceTour tour{links, links.nearest_tour(0)};
        tour.improve();
        std::vector<unsigned> cut;
        for (const unsigned start : tour.starts()) {
            const unsigned piece = links.piece_of(start);
            cut.push_back(piece);
            EXPECT_TRUE(links.kind(piece) != PieceLinks::Kind::OneWay ||
                        start == links.first_tip(piece));
        }
        std::ranges::sort(cut);
        for (unsigned piece = 0; piece < pieces.size(); ++piece)
            EXPECT_EQ(cut[piece], piece);
        EXPECT_EQ(cut.size(), pieces.size());
    }
}

}  // namespace
}  // namespace endmill
