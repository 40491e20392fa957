// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

#include <array>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr std::array<std::string_view, 4> keys{"patches_u", "patches_v", "control_points",
                                               "name"};

// One edit of each kind: a letter dropped, added or replaced, and two letters swapped.
TEST(ClosestWord, FindsAWordWithASingleTypingError)
{
    for (const std::string_view slip :
         {"contol_points", "controll_points", "control-points", "contrlo_points"})
        EXPECT_EQ(closest_word(slip, keys), "control_points") << slip;
    EXPECT_EQ(closest_word("patch_u", keys), "patches_u");
    EXPECT_EQ(closest_word("nmae", keys), "name");
}

TEST(ClosestWord, FindsTheWordItselfAtDistanceZero)
{
    for (const std::string_view key : keys)
        EXPECT_EQ(closest_word(key, keys), key);
}

TEST(ClosestWord, FindsNothingThatIsNotClose)
{
    EXPECT_EQ(closest_word("radius", keys), std::nullopt);
    EXPECT_EQ(closest_word("", {}), std::nullopt);
    EXPECT_EQ(closest_word(std::string(1000, 'n'), keys), std::nullopt);
}

// Another letter or another unit is another name, not a slip of the hand.
TEST(ClosestWord, FindsNothingThatSharesLessThanHalfTheName)
{
    constexpr std::array<std::string_view, 5> names{"u", "v", "mm", "s_mm",
                                                    "feed_mm_per_min"};
    for (const std::string_view other : {"x", "cm", "y_mm", "z_mm_per_min"})
        EXPECT_EQ(closest_word(other, names), std::nullopt) << other;
    EXPECT_EQ(closest_word("fed_mm_per_min", names), "feed_mm_per_min");
}

TEST(OneOf, ListsAllAndSuggestsOne)
{
    constexpr std::array<std::string_view, 3> directions{"u", "v", "both"};
    EXPECT_EQ(one_of(directions, "bth"), R"("u", "v" or "both"; did you mean "both"?)");
    EXPECT_EQ(one_of(directions, "sideways"), R"("u", "v" or "both")");
}

}  // namespace
}  // namespace endmill
