// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/core/error.h"
#include "endmill/surface/extent.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(DensityGrid, HasTheAreaOfTheSurface)
{
    for (const char* const name : {"net_rot24_7D", "torus", "gaussian-bump"}) {
        const test::SidedSurfaces part = test::dataset(name);
        const DensityGrid grid{part.part(), 3};
        const double whole = area(part.surfaces);
        const double weights =
            std::accumulate(grid.weights().begin(), grid.weights().end(), 0.0);
        double cells = 0;
        for (const DensityCell& cell : grid.cells())
            cells += cell.area;
        EXPECT_NEAR(weights, whole, 1e-5 * whole) << name;
        EXPECT_NEAR(cells, whole, 1e-5 * whole) << name;
    }
}

TEST(DensityGrid, ReproducesABilinearFunctionOnEverySurface)
{
    const test::SidedSurfaces part{
        {test::plane(30, 20, {2, 3}), test::parallelogram({0, 40, 0}, {10, 0, 0})}};
    const DensityGrid grid{part.part(), 4};
    const auto wanted = [](std::size_t surface, const SurfacePoint& at) {
        return 1.0 + static_cast<double>(surface) + 2 * at.u + 3 * at.v + 4 * at.u * at.v;
    };
    std::vector<double> values(grid.nodes());
    for (const DensityCell& cell : grid.cells()) {
        const auto [a, b, c, d] = grid.corners(cell.node);
        values[a] = wanted(cell.surface, {cell.u.low, cell.v.low});
        values[b] = wanted(cell.surface, {cell.u.high, cell.v.low});
        values[c] = wanted(cell.surface, {cell.u.low, cell.v.high});
        values[d] = wanted(cell.surface, {cell.u.high, cell.v.high});
    }
    for (std::size_t surface = 0; surface < 2; ++surface)
        for (const SurfacePoint at :
             {SurfacePoint{0, 0}, SurfacePoint{0.37, 0.81}, SurfacePoint{1, 1}}) {
            const double value =
                grid.value(std::span<const double>{values}, grid.place(surface, at));
            EXPECT_NEAR(value, wanted(surface, at), 1e-6);
        }
}

TEST(DensityGrid, HasLinesOnTheBordersOfPatchesAndTheSpacingBetween)
{
    const test::SidedSurfaces part{{test::plane(30, 20, {3, 2})}};
    const DensityGrid grid{part.part(), 5};
    EXPECT_EQ(grid.cells().size(), 6U * 4U);
    EXPECT_EQ(grid.nodes(), 7U * 5U);
    for (const DensityCell& cell : grid.cells()) {
        EXPECT_NEAR(cell.length_u, 5, 1e-12);
        EXPECT_NEAR(cell.length_v, 5, 1e-12);
        EXPECT_EQ(cell.i, static_cast<int>(cell.u.low));
        EXPECT_EQ(cell.j, static_cast<int>(cell.v.low));
    }
    EXPECT_THROW((DensityGrid{part.part(), 0}), DomainError);
}

}  // namespace
}  // namespace endmill
