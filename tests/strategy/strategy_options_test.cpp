// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy_options.h"

#include <set>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(StrategyName, IsOneWordForEachStrategy)
{
    std::set<std::string_view> names;
    for (const Strategy strategy : every_strategy)
        names.insert(strategy_name(strategy));
    EXPECT_EQ(names.size(), every_strategy.size());
    EXPECT_FALSE(names.contains(""));
    EXPECT_TRUE(names.contains("iso-scallop"));
}

}  // namespace
}  // namespace endmill
