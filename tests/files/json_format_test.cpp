// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/json_format.h"

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

std::string complaint_of_format(const std::string& text)
{
    return complaint_of([&] {
        constexpr std::array<std::string_view, 2> keys{"format", "size"};
        const FormatDocument document{text, "f.json", {}, "endmill-thing/2"};
        const JsonValue root = document.root();
        root.allow_only(keys);
        EXPECT_EQ(root.member("format").text(), "endmill-thing/2");
    });
}

TEST(JsonFormat, IsTheExpectedFormatOrAnError)
{
    EXPECT_EQ(complaint_of_format(R"({"format": "endmill-thing/2"})"), "accepted");
    EXPECT_THAT(complaint_of_format(R"({"format": "endmill-thing/3"})"),
                HasSubstr("E_JSON f.json:/format: made by a newer version"));
    EXPECT_THAT(complaint_of_format(R"({"format": "endmill-thing/1"})"),
                HasSubstr("E_FORMAT"));
    EXPECT_THAT(complaint_of_format(R"({"format": "endmill-other/3"})"),
                HasSubstr("E_FORMAT"));
    EXPECT_THAT(complaint_of_format(R"({"format": "endmill-thing/x"})"),
                HasSubstr("E_FORMAT"));
    EXPECT_THAT(complaint_of_format("{}"), HasSubstr("\"format\" is missing"));
    EXPECT_THAT(complaint_of_format(R"({"format": 2})"), HasSubstr("expected a string"));
    EXPECT_THAT(complaint_of_format(R"({"format": "endmill-thing/2", "sise": 1})"),
                HasSubstr("sise"));
    // The version is checked before the keys, which may differ.
    EXPECT_THAT(complaint_of_format(R"({"format": "endmill-thing/3", "sise": 1})"),
                HasSubstr("newer version"));
    EXPECT_THAT(complaint_of_format("solid x"), HasSubstr("E_FORMAT"));
}

TEST(JsonFormat, TakesItsNameFromTheFileIfItHasNone)
{
    const JsonDocument named{"{\"name\": \"a\\u001bb\", \"source\": \"me\"}", "f"};
    const JsonValue root = named.root();
    EXPECT_EQ(name_or_stem(root, "folder/stem.json"), "ab");
    EXPECT_EQ(remark(root, "source"), "me");
    EXPECT_EQ(remark(root, "origin"), "");
    const JsonDocument silent{"{}", "f"};
    const JsonValue nothing = silent.root();
    EXPECT_EQ(name_or_stem(nothing, "folder/stem.json"), "stem");
}

TEST(JsonFormat, KeepsNumbersInTheirRange)
{
    const JsonDocument document{R"({"a": 0, "b": 2, "c": "x"})", "f"};
    const JsonValue root = document.root();
    const NumberRange open{.above = 0, .most = 2, .from = false, .code = "E_X"};
    const NumberRange closed{.above = 0, .most = 2, .from = true, .code = "E_X"};
    EXPECT_THAT(complaint_of([&] { find_number(root, "a", open); }),
                HasSubstr("E_X f:/a: 0; expected a number above 0, at most 2"));
    EXPECT_EQ(find_number(root, "a", closed), 0);
    EXPECT_EQ(find_number(root, "b", open), 2);
    EXPECT_THAT(complaint_of([&] {
                    find_number(root, "b", {.above = 0, .most = 1, .from = true});
                }),
                HasSubstr("E_JSON f:/b: 2; expected a number from 0 to 1"));
    EXPECT_THAT(complaint_of([&] { find_number(root, "c", open); }),
                HasSubstr("expected a number"));
    EXPECT_FALSE(find_number(root, "d", open));
}

}  // namespace
}  // namespace endmill
