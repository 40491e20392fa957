// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/page/page.h"

#include <array>
#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using testing::Not;

PageShell shell(std::string style = "p{}", std::string script = "f()")
{
    return {
        "<title>@TITLE@</title><style>@STYLE@</style>@STYLE_HASH@ a@b.c "
        "<script id=c>@CONTENT@</script>@NUMBERS@<script>@SCRIPT@</script>@SCRIPT_HASH@",
        std::move(style), "one=", std::move(script), "two="};
}

// The vectors of RFC 4648, section 10.
TEST(Base64, GivesTheVectorsOfTheStandard)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(PageNumbers, StartsEveryArrayAtAMultipleOfEightBytes)
{
    PageNumbers numbers;
    const std::array<std::uint8_t, 3> bytes{1, 2, 3};
    const std::array<float, 2> floats{1, 2};
    const std::array<std::uint32_t, 1> words{7};
    EXPECT_EQ(numbers.add(bytes).offset, 0U);
    const PageArray second = numbers.add(floats);
    EXPECT_EQ(second.offset, 8U);
    EXPECT_EQ(second.length, 2U);
    EXPECT_EQ(second.kind, "float32");
    EXPECT_EQ(numbers.add(words).offset, 16U);
    const PageArray last = numbers.add(std::array<double, 1>{1});
    EXPECT_EQ(last.offset, 24U);
    EXPECT_EQ(last.kind, "float64");
    EXPECT_EQ(numbers.size(), 32U);
    // Python's struct and base64 modules: 01 02 03, 1.0f and 2.0f, 07 00 00 00, 1.0, each filled
    // up with zeros to a multiple of eight.
    EXPECT_EQ(numbers.base64(), "AQIDAAAAAAAAAIA/AAAAQAcAAAAAAAAAAAAAAAAA8D8=");
}

TEST(PageHtml, PutsEachTextWhereItBelongs)
{
    const std::string page = page_html(shell(), "part", "{\"a\": 1}", {});
    EXPECT_EQ(page,
              "<title>part</title><style>p{}</style>one= a@b.c "
              "<script id=c>{\"a\": 1}</script><script>f()</script>two=");
}

TEST(PageHtml, KeepsHostileTextsFromBecomingMarkup)
{
    const std::string page =
        page_html(shell(), "\"><script>alert(1)</script>&'",
                  R"({"name": "</script><img src=x onerror=alert(1)>"})", {});
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(page,
                HasSubstr("&quot;&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;&#39;"));
    EXPECT_THAT(page, HasSubstr("\\u003c/script>\\u003cimg"));
}

TEST(PageHtml, DoesNotReplaceWordsWithinTexts)
{
    EXPECT_THAT(page_html(shell(), "@SCRIPT@", "\"@TITLE@\"", {}),
                HasSubstr("<title>@SCRIPT@</title>"));
}

TEST(PageHtml, RefusesAStyleOrAScriptThatEndsItsElement)
{
    EXPECT_THROW(page_html(shell("</style>"), "", "", {}), DomainError);
    EXPECT_THROW(page_html(shell("", "\"</script\""), "", "", {}), DomainError);
}

}  // namespace
}  // namespace endmill
