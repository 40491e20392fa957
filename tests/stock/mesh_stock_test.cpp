// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/mesh_stock.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

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

// A stock whose rays have the material of a solid, given by its stretch on a line.
template <typename Stretch>
DexelStock dexels_of(const Block& block, double pitch, const Stretch& stretch)
{
    DexelStock stock{block, pitch};
    for (int axis = 0; axis < 3; ++axis) {
        DexelField& field = stock.field(axis);
        std::vector<Dexel> dexels;
        dexels.reserve(static_cast<std::size_t>(field.columns()) * field.rows());
        for (int row = 0; row < field.rows(); ++row)
            for (int column = 0; column < field.columns(); ++column) {
                const std::optional<std::pair<double, double>> on =
                    stretch(field.start(column, row), axis);
                Dexel dexel;
                if (on) {
                    const double length = stock.units(axis) * stock.unit();
                    const auto unit = [&](double s) {
                        return static_cast<std::int32_t>(
                            std::lround(std::clamp(s, 0.0, length) / stock.unit()));
                    };
                    const DexelInterval one{unit(on->first), unit(on->second)};
                    if (one.from < one.to)
                        dexel = {{one}, {one}};
                }
                dexels.push_back(dexel);
            }
        field.assign(dexels);
    }
    return stock;
}

double closed_volume(const DexelStock& stock)
{
    const MeshReport report = mesh_report(stock_mesh(stock));
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.inconsistent_edges, 0U);
    return report.volume.value_or(0);
}

TEST(DexelMesh, OfABlockIsThatBlock)
{
    const Block block{{-1, 2, 3}, {9, 7, 6}};
    const TriangleMesh mesh = stock_mesh(DexelStock{block, 0.7});
    EXPECT_NEAR(closed_volume(DexelStock{block, 0.7}), 150, 1e-4);
    const Block box = mesh_box(mesh);
    EXPECT_LE((box.low - block.low).norm(), 1e-5);
    EXPECT_LE((box.high - block.high).norm(), 1e-5);
}

// The solid below a plane keeps its flat side and its sharp edges: the error is far below that
// of chamfers as wide as half a pitch along the four slanted edges.
TEST(DexelMesh, OfAPlaneCutKeepsItsEdges)
{
    const Vec3 normal = Vec3{0.3, 0.2, 1}.normalized();
    const Block block{{0, 0, 0}, {8, 6, 5}};
    const Vec3 on_plane{4, 3, 2.5};
    const DexelStock stock = dexels_of(block, 0.5, [&](const Vec3& start, int axis) {
        return std::optional{std::pair{0.0, normal.dot(on_plane - start) / normal[axis]}};
    });
    // Its middle height is 2.5, and it passes through the upright sides only.
    const double chamfers = 0.5 * 0.5 / 8 * 2 * (8 + 6);
    EXPECT_NEAR(closed_volume(stock), 8 * 6 * 2.5, chamfers / 10);
}

double sphere_mesh_volume(double radius, double pitch)
{
    const Block block{Vec3::Constant(-radius - 0.3), Vec3::Constant(radius + 0.4)};
    return closed_volume(dexels_of(
        block, pitch,
        [&](const Vec3& start, int axis) -> std::optional<std::pair<double, double>> {
            const double middle = -start[axis];
            const double across2 = start.squaredNorm() - start[axis] * start[axis];
            if (across2 >= radius * radius)
                return std::nullopt;
            const double half = std::sqrt(radius * radius - across2);
            return std::pair{middle - half, middle + half};
        }));
}

TEST(DexelMesh, VolumeOfASphereConvergesWithTheSquareOfThePitch)
{
    const double radius = 5;
    const double exact = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
    const double coarse = std::abs(sphere_mesh_volume(radius, 1) - exact);
    const double fine = std::abs(sphere_mesh_volume(radius, 0.25) - exact);
    EXPECT_LT(coarse, 0.02 * exact);
    EXPECT_LT(fine, coarse / 8);
}

TEST(DexelMesh, WithoutMaterialIsEmpty)
{
    const DexelStock stock = dexels_of({{0, 0, 0}, {3, 3, 3}}, 1, [](const Vec3&, int) {
        return std::optional<std::pair<double, double>>{};
    });
    EXPECT_TRUE(stock_mesh(stock).triangles().empty());
}

// Random rays, which do not agree with each other: the mesh is closed all the same.
TEST(DexelMesh, IsClosedForAnyRays)
{
    test::Random random{7};
    const DexelStock stock =
        dexels_of({{0, 0, 0}, {6, 5, 4}}, 0.5, [&](const Vec3&, int) {
            const double from = random.uniform(-1, 4);
            return std::optional{std::pair{from, from + random.uniform(0, 4)}};
        });
    const TriangleMesh mesh = stock_mesh(stock);
    EXPECT_FALSE(mesh.triangles().empty());
    EXPECT_TRUE(mesh_report(mesh).closed);
}

}  // namespace
}  // namespace endmill
