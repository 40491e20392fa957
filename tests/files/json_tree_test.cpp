// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/json_tree.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using std::string_literals::operator""s;
using testing::HasSubstr;

// The error in `text` as "PLACE: …"; "accepted" if there is none.
std::string json_tree_complaint(const std::string& text)
{
    try {
        json_tree(text, "f", {});
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
    std::string found;  // part of it
};

class MalformedJson : public testing::TestWithParam<BadText> {};

TEST_P(MalformedJson, IsRefusedAtItsPlace)
{
    const std::string complaint = json_tree_complaint(GetParam().text);
    EXPECT_THAT(complaint, testing::StartsWith(GetParam().place + ": "));
    EXPECT_THAT(complaint, HasSubstr(GetParam().found));
    for (const char character : complaint)
        EXPECT_FALSE(static_cast<unsigned char>(character) < 0x20) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, MalformedJson,
    testing::Values(BadText{"{\"a\": 1,}", "1:9", "unexpected '}'"},
                    BadText{"[1 2]", "1:4", "unexpected number literal; expected ']'"},
                    BadText{"{\n \"a\"\n 1}", "3:2", "expected ':'"},
                    BadText{"[01]", "1:3", "expected ']'"},
                    BadText{"{} x", "1:4", "expected end of input"},
                    BadText{"{}\0x"s, "1:3", "a NUL byte"},
                    BadText{"[1,", "1:4", "unexpected end of input"},
                    BadText{"['a']", "1:2", "invalid literal"},
                    BadText{"[\"ä\", }", "1:7", "unexpected '}'"},
                    BadText{"[\"\x1b\"]", "1:3", "U+001B (ESC) must be escaped"}));

INSTANTIATE_TEST_SUITE_P(
    NotANumber, MalformedJson,
    testing::Values(BadText{"[NaN]", "1:2", "NaN is not a JSON number"},
                    BadText{"[Infinity]", "1:2", ": Infinity is not a JSON number"},
                    BadText{"[0, -Infinity]", "1:5", "-Infinity is not a JSON number"},
                    BadText{"[1e999]", "1:6",
                            "overflow parsing '1e999'; expected a finite number"},
                    BadText{"[-1e999]", "1:7", "overflow parsing '-1e999'"},
                    BadText{"{\"x\": [1, 1e-999]}", "/x/1", "1e-999 underflows to zero"},
                    BadText{"[[], [0, -0.1e-400]]", "/1/1", "-0.1e-400 underflows"}));

INSTANTIATE_TEST_SUITE_P(BadUtf8, MalformedJson,
                         testing::Values(BadText{"[\"\xff\"]", "1:3", "ill-formed UTF-8"},
                                         BadText{"[\"\xc3\"]", "1:4", "ill-formed UTF-8"},
                                         BadText{"[\"\xed\xa0\x80\"]", "1:4",
                                                 "ill-formed UTF-8"}));

INSTANTIATE_TEST_SUITE_P(DuplicateKeys, MalformedJson,
                         testing::Values(BadText{"{\"a\": 1, \"a\": 2}", "/a",
                                                 "duplicate key \"a\""},
                                         BadText{"[{\"b\": {\"a/~\": 1, \"a/~\": 1}}]",
                                                 "/0/b/a~1~0", "duplicate key \"a/~\""}));

TEST(JsonTree, NamesTheInvalidNumber)
{
    for (const std::string word :
         {"NaN", "nan", "-NaN", "Infinity", "-Infinity", "+Infinity", "inf", "-inf"}) {
        EXPECT_EQ(
            json_tree_complaint("{\"x\":\n[1, " + word + ", 2]}"),
            "2:5: f:2:5: " + word + " is not a JSON number; expected a finite number");
        EXPECT_EQ(json_tree_complaint(word),
                  "1:1: f:1:1: " + word +
                      " is not a JSON number; expected a finite "
                      "number");
    }
    for (const std::string word : {"nano", "1-Infinity", "Nan0", "bezier", "-", "nul"})
        EXPECT_THAT(json_tree_complaint("[" + word + "]"),
                    testing::Not(HasSubstr("a finite number")))
            << word;
}

TEST(JsonTree, AcceptsAByteOrderMarkAndZerosOfAnySpelling)
{
    EXPECT_EQ(json_tree_complaint("\xef\xbb\xbf{}"), "accepted");
    EXPECT_EQ(json_tree_complaint("[0, -0, 0.000, 0e5, 0e-999, 5e-324]"), "accepted");
    EXPECT_EQ(json_tree_complaint("[{\"a\": 1}, {\"a\": 1}]"), "accepted");
}

TEST(JsonTree, NestsSixtyFourDeepAndNoDeeper)
{
    const auto nested = [](int depth) {
        return std::string(depth, '[') + std::string(depth, ']');
    };
    EXPECT_EQ(json_tree_complaint(nested(64)), "accepted");
    EXPECT_THAT(json_tree_complaint(nested(65)), testing::StartsWith("1:65: "));
    EXPECT_THAT(json_tree_complaint(std::string(1000000, '[')), HasSubstr("64 levels"));
    EXPECT_EQ(json_tree_complaint("\"" + std::string(100, '[') + "\""), "accepted");
}

TEST(JsonTree, RefusesATreeBeyondTheMemoryLimit)
{
    std::string text = "[";
    for (int i = 0; i < 100000; ++i)
        text += "{},";
    text += "0]";
    // 100 000 values of 16 bytes and as many empty maps of 48 bytes.
    const double least_gib = 1e5 * (16 + 48) / (1 << 30);
    EXPECT_THAT([&] { json_tree(text, "f", {.max_memory_gib = least_gib}); },
                testing::ThrowsMessage<LimitError>(HasSubstr("f: reading it needs")));
    EXPECT_NO_THROW(json_tree(text, "f", {.max_memory_gib = 5 * least_gib}));
}

TEST(JsonTree, HasTheValuesOfTheText)
{
    const auto tree =
        json_tree(R"({"a": [1, -2, 0.5, "t", true, null], "b": {}})", "f", {});
    EXPECT_EQ(tree->dump(), R"({"a":[1,-2,0.5,"t",true,null],"b":{}})");
}

TEST(JsonPointerStep, EscapesAsRfc6901Does)
{
    EXPECT_EQ(json_pointer_step("a/b"), "/a~1b");
    EXPECT_EQ(json_pointer_step("m~n"), "/m~0n");
    EXPECT_EQ(json_pointer_step(""), "/");
    EXPECT_EQ(json_pointer_step("\x1b[0m"), "/[0m");
}

}  // namespace
}  // namespace endmill
