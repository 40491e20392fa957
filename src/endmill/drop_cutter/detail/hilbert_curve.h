// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace endmill {

/// The number of cell (x, y) along the Hilbert curve through 2^16 by 2^16 cells. Cells
/// with close numbers are close to each other.
/// The numbering is that of [Lawder].
inline std::uint32_t hilbert_number(std::uint32_t x, std::uint32_t y)
{
    constexpr std::uint32_t last = 0xFFFF;
    std::uint32_t number = 0;
    for (std::uint32_t side = 0x8000; side > 0; side /= 2) {
        const std::uint32_t right = (x & side) != 0 ? 1 : 0;
        const std::uint32_t above = (y & side) != 0 ? 1 : 0;
        number += side * side * ((3 * right) ^ above);
        if (above != 0)
            continue;
        if (right != 0) {
            x = last - x;
            y = last - y;
        }
        const std::uint32_t kept = x;
        x = y;
        y = kept;
    }
    return number;
}

}  // namespace endmill
