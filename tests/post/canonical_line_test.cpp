// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/canonical_line.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace endmill {
namespace {

using testing::ElementsAre;

std::vector<std::string> arguments_of(std::string_view arguments)
{
    std::vector<std::string> found;
    while (const auto argument = take_argument(arguments))
        found.emplace_back(*argument);
    return found;
}

TEST(CanonicalLineOf, HasANameAndArguments)
{
    const auto line = canonical_line("   12 N..... SET_FEED_RATE(800.0000)\r");
    ASSERT_TRUE(line);
    EXPECT_EQ(line->name, "SET_FEED_RATE");
    EXPECT_EQ(line->arguments, "800.0000");
}

// The block number is padded to six digits; a longer number leaves no blank.
TEST(CanonicalLineOf, TakesTheNumberOfTheBlock)
{
    for (const std::string number : {"N30     ", "N..... ", "N123456789"}) {
        const std::string text = "1 " + number + "FINISH()";
        const auto line = canonical_line(text);
        ASSERT_TRUE(line);
        EXPECT_EQ(line->name, "FINISH");
        EXPECT_EQ(line->arguments, "");
    }
}

TEST(CanonicalLineOf, AcceptsParenthesesInComments)
{
    const auto line = canonical_line("1 N..... COMMENT(\"a (b), c\")");
    ASSERT_TRUE(line);
    EXPECT_EQ(line->arguments, "\"a (b), c\"");
}

TEST(CanonicalLineOf, RefusesOtherLines)
{
    for (const std::string line :
         {"", "12", "N10 G0 X1", "12 N.....", "12 N..... ", "12 N..... NAME",
          "N..... NAME()", "12 N..... NAME(", "12 N..... (a)", "12 X..... NAME()",
          "12 N..... name()"})
        EXPECT_FALSE(canonical_line(line)) << line;
}

TEST(TakeArgument, CutsAtCommas)
{
    EXPECT_THAT(arguments_of("1.0000, -2.5 ,CANON_XYZ"),
                ElementsAre("1.0000", "-2.5", "CANON_XYZ"));
    EXPECT_THAT(arguments_of("1,,2"), ElementsAre("1", "", "2"));
    EXPECT_THAT(arguments_of(" "), ElementsAre());
}

}  // namespace
}  // namespace endmill
