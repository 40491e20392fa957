// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/folder_lock.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/staging_folder.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

// How long the children of a process that was killed may take to end, and how often to look.
constexpr std::chrono::seconds longest_end{10};
constexpr std::chrono::milliseconds look_interval{5};

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& what,
                         const std::string& process)
{
    throw OutputError{shown_path(folder) + ": " + what +
                      " is at work in this folder, process " + process +
                      "; expected its end, or another folder"};
}

[[noreturn]] void fail_to(const std::string& act, const std::filesystem::path& file,
                          int error)
{
    throw OutputError{"cannot " + act + " " + shown_path(file) + ": " +
                      std::generic_category().message(error)};
}

// The name of this machine.
std::string this_host()
{
    std::array<char, 65> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

// The owner that the file names, such as "812 on mill"; "unknown" while it is being written.
std::string owner_in(int descriptor)
{
    std::array<char, 100> text{};
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
    std::string_view owner{text.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
    owner = owner.substr(0, owner.find('\n'));
    return owner.empty() ? "unknown" : printable(owner);
}

// Whether the owner exists; true if it is not known or on another machine.
bool lives(const std::string& owner)
{
    const auto number = number_from_text(owner.substr(0, owner.find(' ')));
    return !number || !owner.ends_with(" on " + this_host()) ||
           is_at_work(static_cast<pid_t>(*number));
}

// The error of taking the lock; 0 if it was taken.
int lock_error(int descriptor)
{
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
        if (errno != EINTR)
            return errno;
    return 0;
}

// Whether the open file is still the one of this name: its last owner may have removed it.
bool is_still_there(int descriptor, const std::filesystem::path& file)
{
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& what)
    : file_{folder / ".endmill-lock"}
{
    const auto start = std::chrono::steady_clock::now();
    while (descriptor_ < 0) {
        // Not closed on exec: child processes hold the lock too.
        const int descriptor = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW,
                                      0666);  // NOLINT(android-cloexec-open)
        if (descriptor < 0)
            fail_to("open", file_, errno);
        const int error = lock_error(descriptor);
        if (error == 0 && is_still_there(descriptor, file_)) {
            descriptor_ = descriptor;
            break;
        }
        const std::string owner = owner_in(descriptor);
        ::close(descriptor);
        if (error == EWOULDBLOCK) {
            if (lives(owner) || std::chrono::steady_clock::now() - start > longest_end)
                refuse(folder, what, owner);
            std::this_thread::sleep_for(look_interval);
        } else if (error != 0) {
            fail_to("lock", file_, error);
        }
    }
    const std::string number = std::to_string(::getpid()) + " on " + this_host() + "\n";
    const bool is_written = ::ftruncate(descriptor_, 0) == 0 &&
                            ::pwrite(descriptor_, number.data(), number.size(), 0) ==
                                static_cast<ssize_t>(number.size());
    if (!is_written) {
        const int error = errno;
        ::unlink(file_.c_str());
        ::close(descriptor_);
        fail_to("write", file_, error);
    }
}

FolderLock::~FolderLock()
{
    ::unlink(file_.c_str());  // while it is locked, so that nobody else's file is removed
    ::close(descriptor_);
}

}  // namespace endmill
