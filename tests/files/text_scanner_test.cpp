// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/text_scanner.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using std::string_view_literals::operator""sv;

TextScanner scanner(std::string_view text)
{
    return {text, {"f.txt", "E_TEXT", '#'}};
}

// "CODE message" of the error when `read` reads the first line of `text`.
template <class Read>
std::string text_scanner_complaint(std::string_view text, const Read& read)
{
    TextScanner words = scanner(text);
    words.next_line();
    return complaint_of([&] { read(words); });
}

std::string complaint_about_number(std::string_view text)
{
    return text_scanner_complaint(text, [](TextScanner& words) { words.number(); });
}

std::string complaint_about_whole_number(std::string_view text)
{
    return text_scanner_complaint(text, [](TextScanner& words) { words.whole_number(); });
}

double number_in(std::string_view text)
{
    TextScanner words = scanner(text);
    words.next_line();
    return words.number();
}

TEST(TextScanner, GivesTheWordsOfEachLineThatHasSome)
{
    TextScanner words =
        scanner("\xef\xbb\xbf\n one\ttwo \r\n# comment\n\n  three#four\n \t\nfive");
    ASSERT_TRUE(words.next_line());
    EXPECT_EQ(words.line(), 2U);
    EXPECT_EQ(words.word(), "one");
    EXPECT_FALSE(words.at_line_end());
    EXPECT_EQ(words.word(), "two");
    EXPECT_TRUE(words.at_line_end());
    EXPECT_EQ(words.word(), "");
    ASSERT_TRUE(words.next_line());
    EXPECT_EQ(words.line(), 5U);
    EXPECT_EQ(words.word(), "three");
    EXPECT_TRUE(words.at_line_end());
    ASSERT_TRUE(words.next_line());
    words.skip_line();
    EXPECT_EQ(words.line(), 7U);
    EXPECT_EQ(words.word(), "");
    EXPECT_FALSE(words.next_line());
    EXPECT_EQ(words.word(), "");
}

TEST(TextScanner, GivesTheWordsOfAllLines)
{
    TextScanner words = scanner("a b\n\n c\n");
    for (const char* const word : {"a", "b", "c", "", ""})
        EXPECT_EQ(words.word_across_lines(), word);
}

TEST(TextScanner, CountsTheBytesUpToALinesEnd)
{
    TextScanner words = scanner("ab\r\nc d\nrest");
    EXPECT_EQ(words.bytes_up_to_line_end(), 0U);
    words.next_line();
    EXPECT_EQ(words.bytes_up_to_line_end(), 4U);
    words.next_line();
    words.word();
    EXPECT_EQ(words.bytes_left_in_line(), 2U);
    EXPECT_EQ(words.bytes_up_to_line_end(), 8U);
    words.next_line();
    EXPECT_EQ(words.bytes_up_to_line_end(), 12U);
}

TEST(TextScanner, ReadsNumbersAsTheyAreSpelled)
{
    EXPECT_EQ(number_in("0.1"), 0.1);
    EXPECT_EQ(number_in(" +2.5e-3\t"), 2.5e-3);
    EXPECT_EQ(number_in("-7"), -7);
    EXPECT_EQ(number_in("1.4e-45"), 1.4e-45);
    EXPECT_EQ(number_in("5e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(number_in("-inf"), -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(number_in("nan")));

    TextScanner words = scanner("-9223372036854775808 12\n");
    words.next_line();
    EXPECT_EQ(words.whole_number(), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(words.whole_number(), 12);
    EXPECT_NO_THROW(words.expect_line_end());
}

TEST(TextScanner, RefusesWordsThatAreNotNumbers)
{
    EXPECT_EQ(complaint_about_number("\nabc"),
              "E_TEXT f.txt:2: \"abc\"; expected a number");
    EXPECT_EQ(complaint_about_number("1,5"),
              "E_TEXT f.txt:1: \"1,5\"; expected a number, with \".\" as decimal sign");
    EXPECT_EQ(complaint_about_number("1e999"),
              "E_RANGE f.txt:1: \"1e999\"; expected a number that a double can hold");
    EXPECT_EQ(complaint_about_number("1e-999"),
              "E_RANGE f.txt:1: \"1e-999\"; expected a number that a double can hold");
    EXPECT_EQ(text_scanner_complaint(
                  "1", [](TextScanner& words) { words.number(), words.number(); }),
              "E_TEXT f.txt:1: end of line; expected a number");
    EXPECT_EQ(text_scanner_complaint("1\n",
                                     [](TextScanner& words) {
                                         words.next_line();
                                         words.number();
                                     }),
              "E_TEXT f.txt:1: end of file; expected a number");
    for (const auto word : {"+-1"sv, "++1"sv, "1x"sv, "0x10"sv, "1.2.3"sv, "-"sv, "1_0"sv,
                            "1\0"sv, "nano"sv})
        EXPECT_TRUE(complaint_about_number(word).starts_with("E_TEXT f.txt:1: ")) << word;
}

TEST(TextScanner, RefusesWordsThatAreNotWholeNumbers)
{
    EXPECT_EQ(complaint_about_whole_number("2.9"),
              "E_TEXT f.txt:1: \"2.9\"; expected a whole number");
    EXPECT_EQ(complaint_about_whole_number("9223372036854775808"),
              "E_RANGE f.txt:1: \"9223372036854775808\"; "
              "expected a whole number of at most 64 bits");
    for (const auto word : {"-"sv, "1e3"sv, "+1"sv, "--1"sv, "x"sv})
        EXPECT_TRUE(
            complaint_about_whole_number(word).ends_with("expected a whole number"))
            << word;
}

TEST(TextScanner, RefusesMoreWordsThanExpected)
{
    EXPECT_EQ(text_scanner_complaint("a  b",
                                     [](TextScanner& words) { words.expect_line_end(); }),
              "E_TEXT f.txt:1: \"a\"; expected the end of the line");
}

TEST(TextScanner, ShowsNoControlCharactersAndNoLongWords)
{
    EXPECT_EQ(complaint_about_number("\x1b[2Jx"),
              "E_TEXT f.txt:1: \"[2Jx\"; expected a number");
    EXPECT_EQ(complaint_about_number(std::string(1000, 'x')),
              "E_TEXT f.txt:1: \"" + std::string(40, 'x') + "…\"; expected a number");
}

TEST(TextScanner, RefusesLinesOverOneMebibyte)
{
    const std::string longest(1048576, 'x');
    TextScanner sound = scanner(longest);
    EXPECT_TRUE(sound.next_line());
    const std::string text = "a\n" + longest + "x\n";
    TextScanner words = scanner(text);
    words.next_line();
    EXPECT_EQ(complaint_of([&] { words.next_line(); }),
              "E_LIMIT f.txt:2: line is longer than 1 MiB; "
              "expected lines of at most 1048576 bytes");
}

}  // namespace
}  // namespace endmill
