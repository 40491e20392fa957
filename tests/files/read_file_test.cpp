// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/read_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "as_nobody.h"
#include "endmill/core/error.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using std::string_view_literals::operator""sv;

std::string code_and_message(const std::filesystem::path& path)
{
    try {
        read_file(path);
    } catch (const FormatError& error) {
        return error.code() + " " + error.what();
    }
    return "read";
}

TEST(ReadFile, GivesEveryByteAsItStands)
{
    const TemporaryFolder folder;
    std::string content = "\xef\xbb\xbf{\r\n" + std::string(100000, 'x');
    for (int byte = 0; byte < 256; ++byte)
        content += static_cast<char>(byte);
    EXPECT_EQ(read_file(folder.put("a", content)), content);
    EXPECT_EQ(read_file(folder.put("b", "x")), "x");
}

TEST(ReadFile, StatesWhyAFileCannotBeOpened)
{
    const TemporaryFolder folder;
    EXPECT_THAT(
        code_and_message(folder.path() / "none"),
        testing::AllOf(testing::StartsWith("E_OPEN"),
                       testing::HasSubstr("none: cannot open: No such file or "
                                          "directory; expected an existing file")));
    EXPECT_THAT(code_and_message(folder.path()),
                testing::AllOf(testing::StartsWith("E_OPEN"),
                               testing::HasSubstr("is a directory")));
}

TEST(ReadFile, ReportsAMissingPermission)
{
    const TemporaryFolder folder;
    const auto path = folder.put("secret", "text");
    ::chmod(folder.path().c_str(), 0755);
    ::chmod(path.c_str(), 0);
    std::string message;
    {
        const AsNobody nobody;
        message = code_and_message(path);
    }
    EXPECT_THAT(message, testing::AllOf(
                             testing::StartsWith("E_OPEN"),
                             testing::HasSubstr("permission denied; expected a file that "
                                                "you may read")));
}

TEST(ReadFile, DoesNotWaitForAPipeOrADevice)
{
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(code_and_message(pipe), testing::HasSubstr("a device or a pipe"));
    EXPECT_THAT(code_and_message("/dev/zero"), testing::HasSubstr("a device or a pipe"));
}

TEST(ReadFile, RefusesFilesThatAreEmptyOrWhiteSpace)
{
    const TemporaryFolder folder;
    for (const auto content : {""sv, " \n\t\r\n"sv})
        EXPECT_THAT(code_and_message(folder.put("a", content)),
                    testing::AllOf(testing::StartsWith("E_EMPTY"),
                                   testing::HasSubstr("file is empty; expected a file")));
}

// The magic numbers of gzip (RFC 1952), zip, xz, bzip2 and zstd (RFC 8878).
TEST(ReadFile, RefusesCompressedFiles)
{
    const TemporaryFolder folder;
    for (const auto magic : {"\x1f\x8b\x08"sv, "PK\x03\x04"sv,
                             "\xfd"
                             "7zXZ\0"sv,
                             "BZh91AY"sv, "\x28\xb5\x2f\xfd"sv})
        EXPECT_THAT(code_and_message(folder.put("a", magic)),
                    testing::StartsWith("E_COMPRESSED"));
    EXPECT_THAT(code_and_message(folder.put("a.3MF", "PK\x03\x04"sv)),
                testing::AllOf(testing::StartsWith("E_COMPRESSED"),
                               testing::HasSubstr("3MF is not read"),
                               testing::HasSubstr("exported as .stl")));
    EXPECT_THAT(code_and_message(folder.put("a.stl.gz", "\x1f\x8b\x08"sv)),
                testing::HasSubstr("gunzip -k"));
}

TEST(ReadFile, RefusesAFileLargerThanTheLimitBeforeReadingIt)
{
    const TemporaryFolder folder;
    const auto path = folder.put("sparse", "{");
    std::filesystem::resize_file(path, std::uintmax_t{9} << 30U);
    EXPECT_THAT([&] { read_file(path); },
                testing::ThrowsMessage<LimitError>(
                    testing::HasSubstr("sparse: reading it needs about 9 GiB")));
    EXPECT_THAT([&] { read_file(folder.put("a", "12345"), {.max_memory_gib = 1e-9}); },
                testing::ThrowsMessage<LimitError>(testing::HasSubstr("1e-09 GiB")));
}

TEST(ReadFile, MessagesShowNoControlCharactersOfAName)
{
    EXPECT_EQ(shown_path("a\x1b[2Jb.json"), "a[2Jb.json");
    EXPECT_THAT(code_and_message("\x1b]0;x\x07none"),
                testing::Not(testing::HasSubstr("\x1b")));
}

}  // namespace
}  // namespace endmill
