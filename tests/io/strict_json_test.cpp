// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/strict_json.h"

#include <array>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::string_literals::operator""s;
using testing::HasSubstr;

// What is wrong with `text`, as "PLACE: …"; "accepted" if nothing.
std::string complaint_about(const std::string& text)
{
    try {
        const JsonDocument document{text, "f"};
        return "accepted";
    } catch (const FormatError& error) {
        EXPECT_EQ(error.code(), "E_JSON");
        EXPECT_EQ(error.file(), "f");
        return error.place() + ": " + error.what();
    }
}

struct BadText {
    std::string text;
    std::string place;  // counted by hand
};

class MalformedJson : public testing::TestWithParam<BadText> {};

TEST_P(MalformedJson, IsRefusedAtItsPlace)
{
    const std::string complaint = complaint_about(GetParam().text);
    EXPECT_THAT(complaint, testing::StartsWith(GetParam().place + ": "));
    for (const char character : complaint)
        EXPECT_FALSE(static_cast<unsigned char>(character) < 0x20) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, MalformedJson,
    testing::Values(BadText{"{\"a\": 1,}", "1:9"}, BadText{"[1 2]", "1:4"},
                    BadText{"{\n \"a\"\n 1}", "3:2"}, BadText{"[01]", "1:3"},
                    BadText{"{} x", "1:4"}, BadText{"{}\0x"s, "1:3"},
                    BadText{"[1,", "1:4"}, BadText{"['a']", "1:2"},
                    BadText{"[\"ä\", }", "1:7"}, BadText{"[\"\x1b\"]", "1:3"}));

INSTANTIATE_TEST_SUITE_P(NotANumber, MalformedJson,
                         testing::Values(BadText{"[NaN]", "1:2"},
                                         BadText{"[Infinity]", "1:2"},
                                         BadText{"[1e999]", "1:6"},
                                         BadText{"[-1e999]", "1:7"},
                                         BadText{"{\"x\": [1, 1e-999]}", "/x/1"},
                                         BadText{"[[], [0, -0.1e-400]]", "/1/1"}));

INSTANTIATE_TEST_SUITE_P(BadUtf8, MalformedJson,
                         testing::Values(BadText{"[\"\xff\"]", "1:3"},
                                         BadText{"[\"\xc3\"]", "1:4"},
                                         BadText{"[\"\xed\xa0\x80\"]", "1:4"}));

INSTANTIATE_TEST_SUITE_P(DuplicateKeys, MalformedJson,
                         testing::Values(BadText{"{\"a\": 1, \"a\": 2}", "/a"},
                                         BadText{"[{\"b\": {\"a/~\": 1, \"a/~\": 1}}]",
                                                 "/0/b/a~1~0"}));

TEST(JsonDocument, AcceptsAByteOrderMarkAndZerosOfAnySpelling)
{
    EXPECT_EQ(complaint_about("\xef\xbb\xbf{}"), "accepted");
    EXPECT_EQ(complaint_about("[0, -0, 0.000, 0e5, 0e-999, 5e-324]"), "accepted");
    EXPECT_EQ(complaint_about("[{\"a\": 1}, {\"a\": 1}]"), "accepted");
}

TEST(JsonDocument, NestsSixtyFourDeepAndNoDeeper)
{
    const auto nested = [](int depth) {
        return std::string(depth, '[') + std::string(depth, ']');
    };
    EXPECT_EQ(complaint_about(nested(64)), "accepted");
    EXPECT_THAT(complaint_about(nested(65)), testing::StartsWith("1:65: "));
    EXPECT_THAT(complaint_about(std::string(1000000, '[')), HasSubstr("64 levels"));
    EXPECT_EQ(complaint_about("\"" + std::string(100, '[') + "\""), "accepted");
}

TEST(JsonDocument, RefusesATreeThatWouldNotFit)
{
    std::string text = "[";
    for (int i = 0; i < 100000; ++i)
        text += "{},";
    text += "0]";
    // 100 000 values of 16 bytes and as many empty maps of 48.
    const double least_gib = 1e5 * (16 + 48) / (1 << 30);
    EXPECT_THROW((JsonDocument{text, "f", {.max_memory_gib = least_gib}}), LimitError);
    EXPECT_NO_THROW((JsonDocument{text, "f", {.max_memory_gib = 5 * least_gib}}));
}

class JsonValueOf {
public:
    explicit JsonValueOf(const std::string& text) : document_{text, "f"} {}

    // What the reader says of member "x" when `read` takes it.
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
    EXPECT_THROW(root.member("b"), FormatError);
    EXPECT_THROW(root.size(), FormatError);
    const JsonValue number = root.member("a");
    EXPECT_THROW(number.find_member("c"), FormatError);
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

TEST(JsonString, ReadsBackAsTheSameText)
{
    for (const std::string& text : {"plain"s, "\"q\" \\ / \n\t"s, "ä\u2028"s, "a\0b"s}) {
        const JsonDocument document{"[" + json_string(text) + "]", "f"};
        const JsonValue root = document.root();
        EXPECT_EQ(root.item(0).text(), text);
    }
}

}  // namespace
}  // namespace endmill
