// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/part_tiles.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

void expect_cover(const Part& part, double pitch, double area)
{
    const PartCharts charts = part_charts(part);
    const std::vector<PartTile> tiles = part_tiles(charts, pitch, 10'000'000);
    double sum = 0;
    std::size_t first = 0;
    for (const PartTile& tile : tiles) {
        EXPECT_EQ(tile.first, first);
        first += static_cast<std::size_t>(tile.cells());
        EXPECT_LE(tile.cells(), most_tile_cells);
        for (int k = 0; k < tile.cells(); ++k) {
            const PartCell cell = tile.cell(k);
            const PartRay ray = *charts.ray(cell.chart, cell.centre());
            sum += cell.area(ray);
            // the half diagonal of a square is 0.71 of its side
            EXPECT_LE(cell.reach(ray), pitch);
        }
    }
    EXPECT_EQ(cell_count(tiles), first);
    EXPECT_NEAR(sum / area, 1, 1e-4);
}

// The rays of a tile stand at the middles of its cells.
TEST(PartTiles, RaysStandAtTheMiddlesOfCells)
{
    for (const Part& part : {Part{std::vector<Surface>{test::random_surface(3, {2, 1})}},
                             Part{test::box_mesh({0, 0, 0}, {2, 2, 2})}}) {
        const PartCharts charts = part_charts(part);
        for (const PartTile& tile : part_tiles(charts, 0.2, 1'000'000)) {
            const std::vector<PartRay> rays = tile_rays(charts, tile);
            const std::vector<PartCell> cells = tile_cells(tile);
            const std::vector<Vec3> points = tile_points(charts, tile);
            ASSERT_EQ(rays.size(), static_cast<std::size_t>(tile.cells()));
            ASSERT_EQ(cells.size(), rays.size());
            ASSERT_EQ(points.size(), rays.size());
            for (int k = 0; k < tile.cells(); ++k) {
                const PartCell cell = tile.cell(k);
                const PartRay expected = *charts.ray(cell.chart, cell.centre());
                const PartRay& found = rays[static_cast<std::size_t>(k)];
                const PartCell& same = cells[static_cast<std::size_t>(k)];
                for (std::size_t c = 0; c < static_cast<std::size_t>(cell.corners); ++c)
                    EXPECT_LT((same.at[c] - cell.at[c]).norm(), 1e-15);
                EXPECT_EQ(same.corners, cell.corners);
                EXPECT_LT((points[static_cast<std::size_t>(k)] - expected.point).norm(),
                          1e-12);
                EXPECT_LT((found.point - expected.point).norm(), 1e-12);
                EXPECT_LT((found.normal - expected.normal).norm(), 1e-12);
                EXPECT_LT((found.du - expected.du).norm(), 1e-11);
                EXPECT_LT((found.dv - expected.dv).norm(), 1e-11);
            }
        }
    }
}

TEST(PartTiles, CoverASurfaceWithCellsNoLargerThanAsked)
{
    for (const double pitch : {20.0, 1.0, 0.13})
        expect_cover(std::vector<Surface>{test::plane(7, 5, {2, 1})}, pitch, 35);
}

TEST(PartTiles, CoverAMeshOfLargeAndSmallTriangles)
{
    for (const double pitch : {20.0, 1.0, 0.13})
        expect_cover(test::flat_mesh(4, 3), pitch, 12);
}

TEST(PartTiles, AreRefusedIfTheyAreTooMany)
{
    const Part part = std::vector<Surface>{test::plane(100, 100)};
    EXPECT_THROW(part_tiles(part_charts(part), 0.01, 1000), LimitError);
    EXPECT_THROW(part_tiles(part_charts(part), 0, 1000), DomainError);
}

}  // namespace
}  // namespace endmill
