// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/output_path.h"

#include <cerrno>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

TEST(OutputPath, IsPlainUnlessItLeavesItsFolder)
{
    for (const char* name : {"a.csv", "u/a.csv", "..a"})
        EXPECT_TRUE(is_plain_name(name)) << name;
    for (const char* name : {"/a.csv", "../a.csv", "u/../a.csv", "./a.csv", "u/", ""})
        EXPECT_FALSE(is_plain_name(name)) << name;
}

TEST(OutputPath, LiesInsideUnlessAFolderOnItIsALink)
{
    const TemporaryFolder place;
    ASSERT_EQ(make_folders(place.path(), "u/v/a.csv"), 0);
    EXPECT_TRUE(lies_inside(place.path(), "u/v/a.csv"));
    fs::create_directory_symlink(place.path() / "u", place.path() / "link");
    EXPECT_FALSE(lies_inside(place.path(), "link/v/a.csv"));
}

TEST(OutputPath, CannotHaveAFileForAFolder)
{
    const TemporaryFolder place;
    place.put("u", "a file");
    EXPECT_EQ(make_folders(place.path(), "u/a.csv"), ENOTDIR);
    EXPECT_EQ(presence(place.path() / "u"), Presence::Present);
    EXPECT_EQ(presence(place.path() / "u/a.csv"), Presence::Absent);
}

TEST(OutputPath, IsNamedByAnErrorWithItsReason)
{
    EXPECT_THAT([] { fail_output("write", "a.csv", ENOSPC); },
                testing::ThrowsMessage<OutputError>(testing::AllOf(
                    testing::HasSubstr("cannot write"), testing::HasSubstr("a.csv"),
                    testing::HasSubstr("No space left"))));
}

}  // namespace
}  // namespace endmill
