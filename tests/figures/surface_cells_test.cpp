// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/surface_cells.h"

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

// The cells of a plane tile it: their outlines lie in it, and their middles are the
// middles of a grid.
TEST(SurfaceCells, TileAPlane)
{
    const std::vector<SurfaceCell> cells = surface_cells(test::plane(40, 20), 4);
    ASSERT_EQ(cells.size(), 16U);
    Vec3 sum = Vec3::Zero();
    for (const SurfaceCell& cell : cells) {
        for (const Vec3& point : cell.outline) {
            EXPECT_NEAR(point.z(), 0, 1e-12);
            EXPECT_LE((point - cell.middle()).cwiseAbs().x(), 5 + 1e-12);
            EXPECT_LE((point - cell.middle()).cwiseAbs().y(), 2.5 + 1e-12);
        }
        sum += cell.middle();
    }
    EXPECT_LT((sum / 16 - Vec3{20, 10, 0}).norm(), 1e-12);
    EXPECT_TRUE(cells.front().is_border[0] && cells.front().is_border[3]);
    EXPECT_FALSE(cells.front().is_border[1] || cells.front().is_border[2]);
}

TEST(SurfaceCells, AreLighterTowardsTheLight)
{
    const SurfaceCell cell = surface_cells(test::plane(40, 20), 1).front();
    const std::string above =
        shade_of(cell, AxonometricView{Angle::degrees(-60), Angle::degrees(60)});
    const std::string aside =
        shade_of(cell, AxonometricView{Angle::degrees(-60), Angle::degrees(0)});
    EXPECT_EQ(above.size(), 7U);
    EXPECT_GT(above, aside);  // of two colours "#rrggbb" the larger one has more red
}

}  // namespace
}  // namespace endmill
