// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/text_lines.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

std::vector<std::string> lines_of(const std::string& text)
{
    TextLines lines{text, {"f", "E_GCODE"}};
    std::vector<std::string> found;
    while (lines.next())
        found.emplace_back(lines.line());
    return found;
}

TEST(TextLines, AreTheTextBetweenLineFeeds)
{
    EXPECT_THAT(lines_of("a\n\nb\r\nc"), testing::ElementsAre("a", "", "b\r", "c"));
    EXPECT_THAT(lines_of("a\n"), testing::ElementsAre("a"));
}

TEST(TextLines, HaveNoByteOrderMark)
{
    EXPECT_THAT(lines_of("\xef\xbb\xbfG0"), testing::ElementsAre("G0"));
}

TEST(TextLines, RefuseAnEmptyFile)
{
    for (const std::string text : {"", " \t\r\n\n", "\xef\xbb\xbf\n"})
        EXPECT_EQ(refusal_of([&] { lines_of(text); }),
                  "E_EMPTY f: file is empty; expected a file with content");
}

TEST(TextLines, AreAtMostAMebibyteLong)
{
    const std::string longest((std::size_t{1} << 20U), 'x');
    EXPECT_EQ(lines_of("a\n" + longest + "\nb").size(), 3U);
    EXPECT_EQ(refusal_of([&] { lines_of("a\n" + longest + "x\nb"); }),
              "E_LIMIT f:2: line is longer than 1 MiB; expected lines of at most 1048576 "
              "bytes");
}

TEST(TextLines, KeepTheLineNumberAndTheRemainingText)
{
    TextLines lines{"a\nb\nc", {"f", "E_GCODE"}};
    lines.next();
    lines.next();
    EXPECT_EQ(lines.number(), 2U);
    EXPECT_EQ(lines.rest(), "c");
    EXPECT_STREQ(lines.complaint("b", "B").what(), "f:2: b; expected B");
    EXPECT_EQ(lines.complaint("b", "B").code(), "E_GCODE");
    EXPECT_EQ(lines.range_complaint("b", "B").code(), "E_RANGE");
}

TEST(Quoted, HasNoControlCharacters)
{
    const std::string long_text(41, 'x');
    EXPECT_EQ(quoted("a\x1b[31mb\xc3"), R"("a\x1b[31mb\xc3")");
    EXPECT_EQ(quoted(std::string_view{long_text}), '"' + std::string(40, 'x') + "...\"");
}

// Code points of RFC 3629: no-break space, byte order mark, zero-width space, a letter of
// four bytes; then bytes that are no character.
TEST(Quoted, ShowsCharactersThatAreHidden)
{
    EXPECT_EQ(quoted("X\xc2\xa0"
                     "1\xef\xbb\xbf\xe2\x80\x8b"),
              R"("X\u00a01\ufeff\u200b")");
    EXPECT_EQ(quoted("\xf0\x90\x8d\x88"), R"("\U00010348")");
    EXPECT_EQ(quoted("\x07\xff\xc0\x80 \r"), R"("\x07\xff\xc0\x80")");
}

TEST(WithoutIndent, BeginsWithAWord)
{
    EXPECT_EQ(without_indent(" \t\rX "), "X ");
    EXPECT_EQ(without_indent("  "), "");
}

TEST(Brief, HasSixDigits)
{
    EXPECT_EQ(brief(0.1 + 0.2), "0.3");
    EXPECT_EQ(brief(-1.25e9), "-1.25e+09");
    EXPECT_EQ(brief(std::numeric_limits<double>::infinity()), "infinite");
    EXPECT_EQ(brief(std::numeric_limits<double>::quiet_NaN()), "not a number");
}

TEST(CheckExtent, RefusesCoordinatesBeyondIt)
{
    TextLines lines{"X", {"f", "E_GCODE"}};
    lines.next();
    EXPECT_NO_THROW(check_extent(-10, 10, lines));
    EXPECT_THROW(check_extent(10.1, 10, lines), FormatError);
    EXPECT_THROW(check_extent(std::numeric_limits<double>::quiet_NaN(), 10, lines),
                 FormatError);
}

// Some programs end lines with CR alone. In a program that is read as one line, a move or
// a comment would swallow those after it.
TEST(TextLines, RefusesACarriageReturnWithinALine)
{
    const auto refusal = [](const std::string& text) {
        TextLines lines{text, {"f", "E_GCODE"}};
        try {
            while (lines.next()) {
            }
            return std::string{"accepted"};
        } catch (const FormatError& error) {
            return error.code() + ' ' + error.what();
        }
    };
    const std::string told =
        ": a carriage return without a line feed; expected lines that end with LF or "
        "CRLF";
    EXPECT_EQ(refusal("G21\rG0 X1\rM2\r"), "E_GCODE f:1" + told);
    EXPECT_EQ(refusal("G21\n\r\nG1 X1\rY2\nM2"), "E_GCODE f:3" + told);
    EXPECT_EQ(refusal("G21\r\nG0 X1\r\r\nM2\r"), "accepted");
}

}  // namespace
}  // namespace endmill
