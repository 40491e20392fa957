// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/read_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double gib = 1 << 30;

TEST(ReadLimits, AllowUpToTheLimitItself)
{
    EXPECT_NO_THROW(require_memory("a.json", 8 * gib, {}));
    EXPECT_THROW(require_memory("a.json", 8.001 * gib, {}), LimitError);
}

TEST(ReadLimits, ARefusalNamesTheFileTheNeedAndTheLimit)
{
    try {
        require_memory("a.json", 12 * gib, {.max_memory_gib = 0.5});
        FAIL();
    } catch (const LimitError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("a.json"));
        EXPECT_THAT(error.what(), testing::HasSubstr("12 GiB"));
        EXPECT_THAT(error.what(), testing::HasSubstr("0.5 GiB"));
    }
}

}  // namespace
}  // namespace endmill
