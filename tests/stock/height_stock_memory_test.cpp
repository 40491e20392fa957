// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/height_stock.h"

#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

const Block saddle_box{{-60, -40, -15}, {60, 40, 20}};

TEST(RequiredBytes, AreAtMostTwelveACell)
{
    for (const double pitch : {0.1, 0.05, 0.02}) {
        const double cells = 120 / pitch * 80 / pitch;
        EXPECT_LE(required_bytes(saddle_box, pitch), 12.4 * cells);
        EXPECT_GE(required_bytes(saddle_box, pitch), 8 * cells);
    }
}

TEST(FittingPitch, FitsAndTheNextFinerOneDoesNot)
{
    for (const double bytes : {5e6, 1e7, 3.3e8, 8e9}) {
        const auto pitch = fitting_pitch(saddle_box, bytes);
        ASSERT_TRUE(pitch);
        EXPECT_LE(required_bytes(saddle_box, *pitch), bytes);
        // The next finer pitch of two digits is finer by 1 % to 10 %.
        EXPECT_GT(required_bytes(saddle_box, *pitch * 0.89), bytes);
    }
}

TEST(FittingPitch, IsEmptyIfNothingFits)
{
    EXPECT_FALSE(fitting_pitch(saddle_box, 1000));
    EXPECT_FALSE(fitting_pitch({{0, 0, 0}, {0, 0, 0}}, 1e9));
}

TEST(RequiredBytes, IncludeTheExtraBytesOfEachCell)
{
    const double cells = 1200 * 800;
    const double more =
        required_bytes(saddle_box, 0.1, 470) - required_bytes(saddle_box, 0.1);
    EXPECT_GE(more, 470 * cells);
    EXPECT_LE(more, 1.03 * 470 * cells);
    const auto pitch = fitting_pitch(saddle_box, 1e8, 470);
    ASSERT_TRUE(pitch);
    EXPECT_LE(required_bytes(saddle_box, *pitch, 470), 1e8);
    EXPECT_GT(required_bytes(saddle_box, *pitch * 0.89, 470), 1e8);
}

TEST(RequireStockMemory, ReportsTheNeedAndAFittingPitch)
{
    EXPECT_NO_THROW(require_stock_memory(saddle_box, 0.1, 8));
    try {
        require_stock_memory(saddle_box, 0.001, 8);
        FAIL() << "85 GiB were accepted";
    } catch (const LimitError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("120 x 80 mm"), std::string::npos) << what;
        EXPECT_NE(what.find("cells of 0.001 mm"), std::string::npos) << what;
        EXPECT_NE(what.find("85 GiB"), std::string::npos) << what;
        EXPECT_NE(what.find("8 GiB (--max-memory)"), std::string::npos) << what;
        EXPECT_NE(what.find("cells of 0.0033 mm fit"), std::string::npos) << what;
    }
    EXPECT_THROW(require_stock_memory(saddle_box, 0, 8), DomainError);
}

}  // namespace
}  // namespace endmill
