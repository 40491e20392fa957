// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/folder_lock.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& folder)
{
    try {
        const FolderLock lock{folder, "a run"};
        return "";
    } catch (const OutputError& error) {
        return error.what();
    }
}

// A process that takes the lock and keeps it until it is killed.
class OtherOwner {
public:
    explicit OtherOwner(const fs::path& folder)
    {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0)
            throw std::runtime_error{"no pipe"};
        process_ = ::fork();
        if (process_ == 0) {
            const FolderLock lock{folder, "a run"};
            if (::write(ends[1], "x", 1) == 1)
                ::pause();
            std::_Exit(1);
        }
        char ready = 0;
        if (::read(ends[0], &ready, 1) != 1)
            throw std::runtime_error{"no lock"};
        ::close(ends[0]);
        ::close(ends[1]);
    }
    ~OtherOwner() { kill(); }
    OtherOwner(const OtherOwner&) = delete;
    OtherOwner& operator=(const OtherOwner&) = delete;

    void kill()
    {
        if (process_ > 0 && ::kill(process_, SIGKILL) == 0)
            ::waitpid(process_, nullptr, 0);
        process_ = 0;
    }
    pid_t process() const { return process_; }

private:
    pid_t process_ = 0;
};

TEST(FolderLock, LeavesNoFile)
{
    const PrivateFolder folder{testing::TempDir()};
    {
        const FolderLock lock{folder.path(), "a run"};
        EXPECT_TRUE(fs::exists(folder.path() / ".endmill-lock"));
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FolderLock, RefusesASecondProcessWithTheNumberOfTheFirst)
{
    const PrivateFolder folder{testing::TempDir()};
    const OtherOwner other{folder.path()};
    EXPECT_THAT(refusal(folder.path()),
                testing::HasSubstr("process " + std::to_string(other.process())));
}

TEST(FolderLock, TakesOverFromAProcessThatWasKilled)
{
    const PrivateFolder folder{testing::TempDir()};
    OtherOwner other{folder.path()};
    other.kill();
    EXPECT_TRUE(fs::exists(folder.path() / ".endmill-lock"));
    EXPECT_EQ(refusal(folder.path()), "");
}

TEST(FolderLock, WaitsForTheChildrenOfAProcessThatWasKilled)
{
    const PrivateFolder folder{testing::TempDir()};
    const pid_t owner = ::fork();
    if (owner == 0) {
        const FolderLock lock{folder.path(), "a run"};
        if (::fork() == 0) {
            ::usleep(500'000);
            std::_Exit(0);
        }
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(owner, nullptr, 0);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(refusal(folder.path()), "");
    EXPECT_GT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds{200});
}

TEST(FolderLock, IsNotMisledByTheContentOfTheFile)
{
    const PrivateFolder folder{testing::TempDir()};
    std::ofstream{folder.path() / ".endmill-lock"} << ::getpid() << "\n";
    EXPECT_EQ(refusal(folder.path()), "");
}

TEST(FolderLock, RefusesALinkInItsPlace)
{
    const PrivateFolder folder{testing::TempDir()};
    fs::create_symlink("/etc/passwd", folder.path() / ".endmill-lock");
    EXPECT_THAT(refusal(folder.path()), testing::HasSubstr("cannot open"));
}

}  // namespace
}  // namespace endmill
