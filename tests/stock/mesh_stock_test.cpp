// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/mesh_stock.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/mesh/mesh_checks.h"
#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

TriangleMesh tetrahedron()
{
    return {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 3}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

// The highest point of the mesh over (x, y) lies on the plane x + y + 2 z = 6.
TEST(MeshStock, HasTheHeightOfTheMeshOverEachCentre)
{
    const HeightStock stock = mesh_stock(tetrahedron(), 0.25);
    const StockGrid& grid = stock.grid();
    EXPECT_EQ(grid.columns, 24);
    EXPECT_EQ(grid.bottom_z, 0);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const double expected = (6 - grid.x(column) - grid.y(row)) / 2;
            EXPECT_NEAR(stock.height(column, row), std::max(0.0, expected), 1e-14);
        }
}

// The mesh of a random stock has its points over the centres of the cells. A grid of two
// thirds of the pitch, starting at the first of them, has a centre over every other
// point.
TEST(MeshStock, OfTheMeshOfAStockIsThatStock)
{
    HeightStock stock = block_stock({{0, 0, -1}, {7.5, 5.5, 0}}, 0.5);
    test::Random random{12};
    for (int row = 0; row < 11; ++row)
        for (int column = 0; column < 15; ++column)
            stock.set_height(column, row, random.uniform(-0.9, 3));
    const HeightStock again = mesh_stock(stock_mesh(stock), 1.0 / 3);
    ASSERT_EQ(again.grid().columns, 21);
    for (int row = 1; row < 11; row += 2)
        for (int column = 1; column < 15; column += 2)
            EXPECT_NEAR(again.height((3 * column - 1) / 2, (3 * row - 1) / 2),
                        stock.height(column, row), 1e-12);
}

TEST(MeshStock, RefusesAMeshThatIsNotClosed)
{
    EXPECT_THROW(mesh_stock(test::flat_mesh(2, 2), 0.5), GeometryError);
    EXPECT_THROW(mesh_stock({}, 0.5), GeometryError);
    EXPECT_THROW(mesh_stock(tetrahedron(), 0), DomainError);
}

TEST(StockMesh, OfABlockIsABox)
{
    const TriangleMesh mesh = stock_mesh(block_stock({{0, 0, -2}, {5, 4, 1}}, 1));
    const MeshReport report = mesh_report(mesh);
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.inconsistent_edges, 0U);
    ASSERT_TRUE(report.volume);
    // The mesh reaches from centre to centre, half a cell less on each side.
    EXPECT_NEAR(*report.volume, 4 * 3 * 3, 1e-12);
}

TEST(StockMesh, LeavesOutCellsWithoutMaterial)
{
    HeightStock stock = block_stock({{0, 0, 0}, {6, 6, 1}}, 1);
    stock.set_height(3, 3, 0);
    const MeshReport report = mesh_report(stock_mesh(stock));
    EXPECT_TRUE(report.closed);
    ASSERT_TRUE(report.volume);
    // Four of the 25 squares have that corner.
    EXPECT_NEAR(*report.volume, 21, 1e-12);
}

TEST(StockMesh, OfALineOfCellsIsEmpty)
{
    EXPECT_TRUE(stock_mesh(block_stock({{0, 0, 0}, {6, 1, 1}}, 1)).triangles().empty());
}

}  // namespace
}  // namespace endmill
