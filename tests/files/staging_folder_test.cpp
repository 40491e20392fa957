// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/staging_folder.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "temporary_folder.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

TEST(StagingFolder, IsKnownByItsName)
{
    const TemporaryFolder place;
    EXPECT_TRUE(is_staging_name(StagingFolder(place.path(), "out").path()));
    for (const char* name : {".endmill-1-0.tmpx", ".endmill--0.tmp", ".endmill-a-0.tmp",
                             ".endmill-1.tmp", "endmill-1-0.tmp", ".endmill-1-.tmp"})
        EXPECT_FALSE(is_staging_name(name)) << name;
}

TEST(StagingFolder, IsAbandonedOnceItsProcessIsGone)
{
    const TemporaryFolder place;
    const StagingFolder own{place.path(), "out"};
    EXPECT_EQ(lock_of_abandoned(own.path()).lock, -1);
    const fs::path gone = place.path() / ".endmill-4194305-0.tmp";  // no such process
    fs::create_directories(gone);
    const Abandoned found = lock_of_abandoned(gone);
    ASSERT_GE(found.lock, 0);
    ::close(found.lock);
    EXPECT_EQ(lock_of_abandoned(place.path() / ".endmill-4194305-1.tmp").lock, -1);
}

TEST(StagingFolder, IsAbandonedByAProcessThatNobodyWaitedFor)
{
    const TemporaryFolder place;
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    siginfo_t info{};
    ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT), 0);
    const fs::path left = place.path() / (".endmill-" + std::to_string(child) + "-0.tmp");
    fs::create_directories(left);
    const Abandoned found = lock_of_abandoned(left);
    ::waitpid(child, nullptr, 0);
    ASSERT_GE(found.lock, 0);
    ::close(found.lock);
}

TEST(StagingFolder, IsRemovedWithItsFilesUnlessReleased)
{
    const TemporaryFolder place;
    fs::path removed;
    fs::path kept;
    {
        const StagingFolder folder{place.path(), "out"};
        removed = folder.path();
        std::ofstream{removed / "a.csv"} << "new";
        StagingFolder other{place.path(), "out"};
        kept = other.path();
        other.release();
    }
    EXPECT_FALSE(fs::exists(removed));
    EXPECT_TRUE(fs::exists(kept));
}

}  // namespace
}  // namespace endmill
