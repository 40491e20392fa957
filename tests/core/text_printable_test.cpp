// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::string_view_literals::operator""sv;

TEST(Printable, LeavesPlainAndAccentedTextAlone)
{
    for (const auto text : {"a plain name"sv, "Fläche"sv, "표면"sv, "𝛿"sv, ""sv})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, RemovesControlCharacters)
{
    EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), "[31mred[0m");
    EXPECT_EQ(printable("a\r\nb\tc\0d\x7f"sv), "abcd");
    EXPECT_EQ(printable("a\xc2\x9b"
                        "31m"),  // U+009B, the one-character form of ESC [
              "a31m");
    EXPECT_EQ(printable("a\u202Etxt.exe\u2028b"), "atxt.exeb");
}

// Every byte that neither begins nor continues a character, by the table of RFC 3629.
TEST(Printable, MarksBytesThatAreNotUtf8)
{
    EXPECT_EQ(printable("\xff\xc0\xc1\xf5"), "????");
    EXPECT_EQ(printable("a\x80z"), "a?z");
    EXPECT_EQ(printable("\xe2\x82"), "??");            // cut off
    EXPECT_EQ(printable("\xe0\x80\xaf"), "???");       // overlong
    EXPECT_EQ(printable("\xed\xa0\x80"), "???");       // surrogate
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "????");  // above U+10FFFF
    EXPECT_EQ(printable("\xf4\x8f\xbf\xbf"), "\xf4\x8f\xbf\xbf");
}

TEST(Printable, ShortensByCharactersNotBytes)
{
    EXPECT_EQ(printable("äöüß", 3), "äöü…");
    EXPECT_EQ(printable("äöü", 3), "äöü");
    EXPECT_EQ(printable("abc", 0), "…");
}

}  // namespace
}  // namespace endmill
