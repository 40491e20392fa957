// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/file_hash.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/job/child_process.h"
#include "job_program.h"

namespace endmill {
namespace {

class FileHash : public testing::Test {
protected:
    std::string hash(const std::string& name, const std::string& content)
    {
        put(folder_.path() / name, content);
        return result_sha256(folder_.path() / name);
    }

    PrivateFolder folder_{testing::TempDir()};
};

TEST_F(FileHash, IsThatOfTheBytes)
{
    // FIPS 180-2, B.1
    EXPECT_EQ(hash("a.txt", "abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(FileHash, LeavesMeasuredTimesOfASummaryOut)
{
    const std::string first =
        hash("summary.json", R"({"a": {"b_s": 1, "c": 2}, "d_ms": 3})");
    EXPECT_EQ(hash("summary.json", R"({"a": {"b_s": 5, "c": 2}, "d_ms": 6})"), first);
    EXPECT_NE(hash("summary.json", R"({"a": {"b_s": 1, "c": 3}, "d_ms": 3})"), first);
    EXPECT_NE(hash("other.json", R"({"b_s": 1})"), hash("other.json", R"({"b_s": 2})"));
}

TEST_F(FileHash, TakesABrokenSummaryAsBytes)
{
    EXPECT_NE(hash("summary.json", "{"), hash("summary.json", "{{"));
    EXPECT_EQ(hash("summary.json", std::string(100'000, '[')).size(), 64);
}

TEST_F(FileHash, OfAFolderDependsOnNamesAndContents)
{
    put(folder_.path() / "b/c.txt", "x");
    put(folder_.path() / "a.txt", "y");
    const std::string first = folder_sha256(folder_.path());
    EXPECT_EQ(folder_sha256(folder_.path()), first);
    std::filesystem::rename(folder_.path() / "b/c.txt", folder_.path() / "b/d.txt");
    EXPECT_NE(folder_sha256(folder_.path()), first);
    EXPECT_THROW(folder_sha256(folder_.path() / "none"), FormatError);
    EXPECT_THROW(result_sha256(folder_.path() / "none"), FormatError);
}

}  // namespace
}  // namespace endmill
