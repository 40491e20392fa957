// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/hilbert_curve.h"

#include <array>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// The curve through the lowest 32 by 32 cells visits each of them once, from neighbour to
// neighbour.
TEST(HilbertCurve, GoesFromCellToNeighbourThroughAll)
{
    constexpr int side = 32;
    std::vector<std::array<int, 2>> cells(side * side, {-1, -1});
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y) {
            const std::uint32_t number = hilbert_number(x, y);
            ASSERT_LT(number, cells.size());
            EXPECT_EQ(cells[number][0], -1);
            cells[number] = {x, y};
        }
    for (std::size_t k = 1; k < cells.size(); ++k)
        EXPECT_EQ(std::abs(cells[k][0] - cells[k - 1][0]) +
                      std::abs(cells[k][1] - cells[k - 1][1]),
                  1);
}

TEST(HilbertCurve, EndsInTheFarCorner)
{
    EXPECT_EQ(hilbert_number(0, 0), 0U);
    EXPECT_EQ(hilbert_number(0xFFFF, 0), 0xFFFFFFFFU);
}

}  // namespace
}  // namespace endmill
