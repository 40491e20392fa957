// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/history_arrays.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

StockHistory history()
{
    return {{{0, 0, 0}, {1, 2, 3}},
            {{Cutter::ball(3), true, {{1, 2, 3}}},
             {Cutter{4, 1}, false, {{4, 5, 6}, {7, 8, 9}, {0, 0, 1}}}}};
}

TEST(HistoryArrays, HaveTheirStatedLength)
{
    const HistoryCounts counts = counts_of(history());
    EXPECT_EQ(counts.runs, 2);
    EXPECT_EQ(counts.tips, 4);
    std::string bytes;
    append_history(bytes, history());
    EXPECT_EQ(static_cast<double>(bytes.size()), history_bytes(counts));
}

TEST(HistoryArrays, AreNamedInTheHead)
{
    const auto found = named_history(history_elements({12, 345}, 0));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->runs, 12);
    EXPECT_EQ(found->tips, 345);
    EXPECT_FALSE(named_history("<FieldData>"));
}

TEST(HistoryArrays, AreReadFromTheirOffset)
{
    std::string bytes = "before";
    append_history(bytes, history());
    const StockHistory found =
        parse_history(bytes, 6, counts_of(history()), "f.vti", ReadLimits{});
    EXPECT_EQ(found.block.high, history().block.high);
    ASSERT_EQ(found.runs.size(), 2U);
    EXPECT_EQ(found.runs[1].cutter, Cutter(4, 1));
    EXPECT_TRUE(found.runs[0].stands_at_first);
    EXPECT_EQ(found.runs[1].tips, history().runs[1].tips);
    EXPECT_THROW(parse_history(bytes, 6, {2, 5}, "f.vti", ReadLimits{}), FormatError);
    EXPECT_THROW(parse_history(bytes, 6, {1, 4}, "f.vti", ReadLimits{}), FormatError);
}

}  // namespace
}  // namespace endmill
