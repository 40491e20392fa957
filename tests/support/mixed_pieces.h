// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/planning/detail/piece_links.h"
#include "random.h"

// Pieces of a path of all kinds at random places.
namespace endmill::test {

/// Reversible, one-way and closed pieces in turn.
inline std::vector<PieceEnds> mixed_pieces(unsigned seed, std::size_t count)
{
    Random random{seed};
    const auto tip = [&] {
        return Vec3{random.uniform(0, 50), random.uniform(0, 50), 0};
    };
    std::vector<PieceEnds> pieces;
    for (std::size_t k = 0; k < count; ++k)
        if (k % 3 == 2)
            pieces.push_back(ClosedPiece{{tip(), tip(), tip()}});
        else
            pieces.push_back(OpenPiece{tip(), tip(), k % 3 == 0});
    return pieces;
}

}  // namespace endmill::test
