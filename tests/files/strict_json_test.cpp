// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/strict_json.h"

#include <array>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace endmill {
namespace {

using testing::HasSubstr;

class JsonValueOf {
public:
    explicit JsonValueOf(const std::string& text) : document_{text, "f"} {}

    // The message about member "x" when `read` reads it.
    template <class Read>
    std::string complaint(Read read) const
    {
        const JsonValue root = document_.root();
        const JsonValue member = root.member("x");
        try {
            read(member);
            return "accepted";
        } catch (const FormatError& error) {
            return error.what();
        }
    }

private:
    JsonDocument document_;
};

std::string whole_number(const std::string& text)
{
    return JsonValueOf{"{\"x\": " + text + "}"}.complaint(
        [](const JsonValue& value) { value.whole_number(1, 10000); });
}

TEST(JsonValue, AWholeNumberIsWrittenAsOne)
{
    EXPECT_EQ(whole_number("1"), "accepted");
    EXPECT_EQ(whole_number("10000"), "accepted");
    for (const std::string text :
         {"0", "-1", "10001", "2.9", "3.0", "1e3", "\"3\"", "null", "true", "[]",
          "18446744073709551615", "99999999999999999999999", "-9223372036854775808"})
        EXPECT_THAT(whole_number(text),
                    HasSubstr("expected a whole number from 1 to 10000"))
            << text;
}

TEST(JsonValue, AWholeNumberMayReachTheEndsOfItsType)
{
    const JsonDocument document{"[9223372036854775807, -9223372036854775808]", "f"};
    const JsonValue root = document.root();
    using Limits = std::numeric_limits<std::int64_t>;
    EXPECT_EQ(root.item(0).whole_number(0, Limits::max()), Limits::max());
    EXPECT_EQ(root.item(1).whole_number(Limits::min(), 0), Limits::min());
}

TEST(JsonValue, GivesTheDoubleThatTheTextSpells)
{
    const JsonDocument document{"[0.1, -1e-300, 5e-324, 3, 123456789012345678901]", "f"};
    const JsonValue root = document.root();
    const std::array expected{0.1, -1e-300, 5e-324, 3.0, 123456789012345678901.0};
    ASSERT_EQ(root.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(root.item(i).number(), expected[i]);
}

TEST(JsonValue, AComplaintNamesThePlaceTheFoundAndTheExpected)
{
    const JsonDocument document{R"({"a/b": [1, {"c": "two"}]})", "f.json"};
    const JsonValue root = document.root();
    const JsonValue list = root.member("a/b");
    const JsonValue item = list.item(1);
    const JsonValue value = item.member("c");
    EXPECT_EQ(value.pointer(), "/a~1b/1/c");
    try {
        value.number();
        FAIL();
    } catch (const FormatError& error) {
        EXPECT_STREQ(error.what(), "f.json:/a~1b/1/c: \"two\"; expected a number");
    }
}

TEST(JsonValue, EchoesOnlyAShortAndPrintablePartOfTheFile)
{
    const std::string text = "{\"x\": \"" + std::string(500, 'y') + "\\u009b\"}";
    const std::string complaint =
        JsonValueOf{text}.complaint([](const JsonValue& value) { value.size(); });
    EXPECT_LT(complaint.size(), 100U);
    EXPECT_THAT(JsonValueOf{R"({"x": "\u001b[2J\u202e"})"}.complaint(
                    [](const JsonValue& value) { value.number(); }),
                testing::Not(testing::AnyOf(HasSubstr("\x1b"), HasSubstr("\u202e"))));
}

TEST(JsonValue, AnUnknownKeyIsAnErrorWithASuggestion)
{
    constexpr std::array<std::string_view, 2> keys{"patches_u", "patches_v"};
    const JsonDocument document{R"({"patch_u": 3})", "f"};
    const JsonValue root = document.root();
    try {
        root.allow_only(keys);
        FAIL();
    } catch (const FormatError& error) {
        EXPECT_EQ(error.place(), "/patch_u");
        EXPECT_THAT(error.what(), HasSubstr("did you mean \"patches_u\"?"));
    }
}

TEST(JsonValue, AMissingKeyIsNamedAndAnOptionalOneIsNot)
{
    const JsonDocument document{R"({"a": 1})", "f"};
    const JsonValue root = document.root();
    EXPECT_FALSE(root.find_member("b"));
    EXPECT_TRUE(root.find_member("a"));
    const auto refuses = [](const std::string& message) {
        return testing::ThrowsMessage<FormatError>(message);
    };
    EXPECT_THAT([&] { root.member("b"); },
                refuses("f: key \"b\" is missing; expected a value under this key"));
    EXPECT_THAT([&] { root.size(); }, refuses("f: an object; expected an array"));
    const JsonValue number = root.member("a");
    EXPECT_THAT([&] { number.find_member("c"); }, refuses("f:/a: 1; expected an object"));
}

TEST(JsonValue, TellsKindsApart)
{
    const std::string file = "f";
    const JsonDocument document{R"({"b": [1], "a": 2.5, "c": false, "d": "1"})", file};
    const JsonValue root = document.root();
    EXPECT_THAT(root.keys(), testing::ElementsAre("a", "b", "c", "d"));
    EXPECT_TRUE(root.member("b").is_array());
    EXPECT_FALSE(root.is_array());
    EXPECT_TRUE(root.member("a").is_number());
    EXPECT_FALSE(root.member("d").is_number());
    EXPECT_TRUE(root.member("c").is_truth());
    EXPECT_FALSE(root.member("a").is_truth());
    EXPECT_THAT([&] { root.member("b").keys(); },
                refuses("f:/b: an array of 1; expected an object"));
}

TEST(JsonValue, ATruthIsTrueOrFalse)
{
    const auto read = [](const JsonValue& value) { value.truth(); };
    EXPECT_EQ(JsonValueOf{R"({"x": true})"}.complaint(read), "accepted");
    EXPECT_EQ(JsonValueOf{R"({"x": false})"}.complaint(read), "accepted");
    for (const char* text : {R"({"x": 1})", R"({"x": "true"})", R"({"x": null})"})
        EXPECT_THAT(JsonValueOf{text}.complaint(read),
                    HasSubstr("expected true or false"));
}

TEST(JsonValue, AWordIsOneOfThoseAllowed)
{
    constexpr std::array<std::string_view, 2> units{"mm", "inch"};
    const auto read = [&](const JsonValue& value) { value.word(units); };
    EXPECT_EQ(JsonValueOf{R"({"x": "inch"})"}.complaint(read), "accepted");
    EXPECT_THAT(JsonValueOf{R"({"x": "inches"})"}.complaint(read),
                HasSubstr("did you mean \"inch\"?"));
    EXPECT_THAT(JsonValueOf{R"({"x": 3})"}.complaint(read), HasSubstr("a string"));
}

}  // namespace
}  // namespace endmill
