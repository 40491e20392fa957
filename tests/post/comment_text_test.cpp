// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/comment_text.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(CommentText, LosesCharactersThatEndACommentOrABlock)
{
    EXPECT_EQ(comment_text("a(b)c\nG0 Z-100\r\t\x1b[31m\x7f%$$d"), "abcG0 Z-100[31md");
    EXPECT_EQ(comment_text(""), "");
}

TEST(CommentText, IsAsciiAndShort)
{
    EXPECT_EQ(comment_text("Fl\xc3\xa4"
                           "che \xe2\x82\xac"),
              "Fl?che ?");
    EXPECT_EQ(comment_text(std::string(1000, 'x')).size(), 80U);
    for (int byte = 0; byte < 256; ++byte)
        for (const char c : comment_text(std::string(1, static_cast<char>(byte)))) {
            EXPECT_TRUE(' ' <= c && c <= '~' && c != '(' && c != ')') << byte;
        }
}

TEST(OpeningComment, NamesThePathAndTheCutter)
{
    EXPECT_EQ(opening_comment("net", Cutter::ball(7.5)),
              "endmill: net, cutter ball:15, tips");
    EXPECT_EQ(opening_comment("net", std::nullopt), "endmill: net, tips");
    EXPECT_EQ(opening_comment("()", std::nullopt), "endmill: tips");
}

// A control shows, logs or evaluates comments that begin with these words.
TEST(OpeningComment, IsNeverACommandOfAControl)
{
    for (const char* name : {"MSG, stop", "DEBUG,#1", "PRINT, x", "LOGOPEN,/etc/x"})
        EXPECT_TRUE(opening_comment(name, {}).starts_with("endmill: ")) << name;
}

}  // namespace
}  // namespace endmill
