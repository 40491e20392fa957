// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/grid_word.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(GridWord, HasShapeFinenessAndNumberOfCells)
{
    EXPECT_EQ(grid_word("hex:10").kind, GridKind::Hex);
    EXPECT_EQ(grid_word("hex:10").cells, 1200);
    EXPECT_EQ(grid_word("cube:10").kind, GridKind::Cube);
    EXPECT_EQ(grid_word("cube:3").cells, 108);
    EXPECT_EQ(grid_word("ico:0").cells, 20);
    EXPECT_EQ(grid_word("ico:4").cells, 5120);
    const GridWord bands = grid_word("latlong:40x16");
    EXPECT_EQ(bands.kind, GridKind::LatLong);
    EXPECT_EQ(bands.fineness, 40);
    EXPECT_EQ(bands.bands, 16);
    EXPECT_EQ(bands.cells, 1200);
}

TEST(GridWord, RefusesOtherNames)
{
    for (const char* name :
         {"", "hex", "hex:", "hex:0", "hex:-1", "hex:1.5", "hex:1 ", "Hex:1", "ico:-1",
          "latlong:2x5", "latlong:5x1", "latlong:5", "latlong:5x", "latlong:5x6x7",
          "hex:1000", "ico:10", "ico:99999999999"})
        EXPECT_THROW(grid_word(name), DomainError) << name;
}

}  // namespace
}  // namespace endmill
