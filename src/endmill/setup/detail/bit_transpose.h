// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace endmill {

/// A matrix of 64 x 64 bits: 64 rows of 64 bits.
using BitBlock = std::array<std::uint64_t, 64>;

/// Transposes the matrix: bit k of word i becomes bit i of word k. Six passes swap
/// squares of 32, 16, ..., 1 bits, which takes about 400 operations instead of 4096.
inline void transpose(BitBlock& block)
{
    std::uint64_t low =
        0xffffffff;  // mask of the columns in the lower half of each square
    for (std::size_t side = 32; side > 0; side /= 2, low ^= low << side) {
        for (std::size_t i = 0; i < 64; i = ((i | side) + 1) & ~side) {
            const std::uint64_t swapped = ((block[i] >> side) ^ block[i | side]) & low;
            block[i | side] ^= swapped;
            block[i] ^= swapped << side;
        }
    }
}

}  // namespace endmill
