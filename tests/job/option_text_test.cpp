// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/option_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "some_program.h"

namespace endmill {
namespace {

std::string text_of(const std::string& value)
{
    const JsonDocument document{"[" + value + "]", "f"};
    const JsonValue root = document.root();
    return error_of([&] { throw Error{"text", option_text(root.item(0))}; });
}

TEST(OptionText, IsTheWordOfTheCommandLine)
{
    EXPECT_EQ(text_of("0.10"), "text 0.1");
    EXPECT_EQ(text_of("20000000"), "text 20000000");
    EXPECT_EQ(text_of("1e7"), "text 10000000");
    EXPECT_EQ(text_of("1e-7"), "text 1e-07");
    EXPECT_EQ(text_of("true"), "text true");
    EXPECT_EQ(text_of("false"), "text false");
    EXPECT_EQ(text_of(R"("ball:10")"), "text ball:10");
    EXPECT_EQ(text_of("[0, 0.5, 1]"), "text 0,0.5,1");
}

TEST(OptionText, RefusesWhatIsNoWord)
{
    using testing::HasSubstr;
    EXPECT_THAT(text_of("null"), HasSubstr("f:/0: null; expected a number, a text"));
    EXPECT_THAT(text_of("{}"), HasSubstr("f:/0: an object; expected a number"));
    EXPECT_THAT(text_of("[]"), HasSubstr("f:/0: an empty array"));
    EXPECT_THAT(text_of(R"([1, "2"])"), HasSubstr("f:/0/1: \"2\"; expected a number"));
    EXPECT_THAT(text_of(R"("")"), HasSubstr("f:/0: an empty text"));
    EXPECT_THAT(text_of(R"("a\nb")"),
                HasSubstr("expected a text without control characters"));
}

TEST(HasControlCharacters, FindsThemAndInvalidUtf8)
{
    EXPECT_FALSE(has_control_characters("ball:10, größer"));
    EXPECT_TRUE(has_control_characters("a\tb"));
    EXPECT_TRUE(has_control_characters("\xff"));
}

}  // namespace
}  // namespace endmill
