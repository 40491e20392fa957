// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/dexel_stock.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

const Block block{{-1, 2, 3}, {9, 7, 6}};

TEST(DexelStock, BlockIsFullOnAllFields)
{
    const DexelStock stock{block, 0.3};
    for (int axis = 0; axis < 3; ++axis) {
        const DexelVolume volume = dexel_volume(stock, axis);
        EXPECT_NEAR(volume.upper, 10 * 5 * 3, 1e-4);
        EXPECT_EQ(volume.lower, volume.upper);
        EXPECT_LE(stock.field(axis).column_step(), 0.3 + 1e-12);
        EXPECT_LE(stock.field(axis).row_step(), 0.3 + 1e-12);
    }
}

TEST(DexelStock, RaysStandInTheMiddlesOfTheCells)
{
    const DexelStock stock{block, 1};
    const DexelField& along_y = stock.field(1);
    // Columns run along z, rows along x.
    EXPECT_EQ(along_y.columns(), 3);
    EXPECT_EQ(along_y.rows(), 10);
    EXPECT_LE((along_y.start(0, 9) - Vec3{8.5, 2, 3.5}).norm(), 1e-12);
}

TEST(DexelStock, FieldTakesTheGivenIntervals)
{
    DexelStock stock{block, 5};
    DexelField& field = stock.field(2);
    std::vector<Dexel> dexels(static_cast<std::size_t>(field.columns()) * field.rows());
    dexels[1] = {{{0, 10}, {20, 30}}, {{2, 9}}};
    field.assign(dexels);
    EXPECT_TRUE(field.upper(0, 0).empty());
    ASSERT_EQ(field.upper(1, 0).size(), 2U);
    EXPECT_EQ(field.upper(1, 0)[1], (DexelInterval{20, 30}));
    EXPECT_EQ(field.lower(1, 0)[0], (DexelInterval{2, 9}));
    EXPECT_NEAR(dexel_volume(stock, 2).upper, 20 * stock.unit() * field.cell_area(),
                1e-12);
    EXPECT_THROW(field.assign(std::vector<Dexel>(1)), DomainError);
}

TEST(DexelStock, LargeBlocksHaveALargerUnit)
{
    EXPECT_EQ((DexelStock{{{0, 0, 0}, {1000, 1, 1}}, 50}.unit()), 0x1p-20);
    EXPECT_EQ((DexelStock{{{0, 0, 0}, {5000, 100, 100}}, 50}.unit()), 0x1p-17);
}

TEST(DexelStock, RefusesWhatIsNoBlockOrDoesNotFit)
{
    EXPECT_THROW((DexelStock{{{0, 0, 0}, {1, 0, 1}}, 1}), DomainError);
    EXPECT_THROW((DexelStock{block, 0}), DomainError);
    EXPECT_NO_THROW(require_dexel_memory(block, 0.1, 1));
    try {
        require_dexel_memory(block, 0.001, 0.01);
        FAIL();
    } catch (const LimitError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("which a resolution of"), std::string::npos) << text;
    }
}

// A ramp: between the centres of the cells the surface is below the higher and above the
// lower one, so the plane itself lies between both sets on every ray.
TEST(DexelsOfHeights, EncloseTheSurfaceBetweenTheCentres)
{
    HeightStock heights{{0, 0, 0.5, 20, 8, 0}, 10};
    const auto height_at = [](double x, double y) { return 2 + 0.5 * x + 0.25 * y; };
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 20; ++column)
            heights.set_height(
                column, row, height_at(heights.grid().x(column), heights.grid().y(row)));
    for (const double pitch : {0.5, 0.35}) {
        const DexelStock stock = dexels_of_heights(heights, pitch);
        const DexelField& along_z = stock.field(2);
        for (int row = 0; row < along_z.rows(); ++row)
            for (int column = 0; column < along_z.columns(); ++column) {
                const Vec3 start = along_z.start(column, row);
                if (start.x() < 0.25 || start.x() > 9.75 || start.y() < 0.25 ||
                    start.y() > 3.75)
                    continue;
                const double exact = height_at(start.x(), start.y());
                const double unit = stock.unit();
                EXPECT_GE(along_z.upper(column, row)[0].to * unit, exact - 1e-9);
                EXPECT_LE(along_z.lower(column, row)[0].to * unit, exact + 1e-9);
                if (pitch == 0.5) {
                    EXPECT_NEAR(along_z.upper(column, row)[0].to * unit, exact, 2e-6);
                    EXPECT_NEAR(along_z.lower(column, row)[0].to * unit, exact, 2e-6);
                }
            }
        const DexelField& along_x = stock.field(0);
        for (int row = 0; row < along_x.rows(); ++row)
            for (int column = 0; column < along_x.columns(); ++column) {
                const Vec3 start = along_x.start(column, row);
                const double exact = (start.z() - 2 - 0.25 * start.y()) / 0.5;
                // the lower set has whole squares only, which end at the last centre
                if (exact < 0.25 || exact > 9 || start.y() < 0.25 || start.y() > 3.75)
                    continue;
                EXPECT_LE(along_x.upper(column, row)[0].from * stock.unit(),
                          exact + 1e-9);
                EXPECT_GE(along_x.lower(column, row)[0].from * stock.unit(),
                          exact - 1e-9);
                EXPECT_EQ(along_x.upper(column, row).size(), 1U);
                EXPECT_EQ(along_x.lower(column, row).size(), 1U);
                EXPECT_EQ(along_x.lower(column, row)[0].to, stock.units(0));
            }
    }
}

TEST(DexelsOfHeights, OfABlockAreThatBlock)
{
    const DexelStock stock = dexels_of_heights(block_stock(block, 0.5), 0.3);
    for (int axis = 0; axis < 3; ++axis) {
        const DexelVolume volume = dexel_volume(stock, axis);
        EXPECT_EQ(volume.upper, dexel_volume(DexelStock{block, 0.3}, axis).upper);
        EXPECT_EQ(volume.lower, volume.upper);
    }
}

TEST(DexelsOfHeights, RefuseAStockWithoutMaterial)
{
    EXPECT_THROW(dexels_of_heights(HeightStock{{0, 0, 1, 4, 4, 0}, 0}, 1), GeometryError);
}

}  // namespace
}  // namespace endmill
