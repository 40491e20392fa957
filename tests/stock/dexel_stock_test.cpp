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

}  // namespace
}  // namespace endmill
