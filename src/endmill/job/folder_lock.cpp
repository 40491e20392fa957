// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/folder_lock.h"

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

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

// The number in the file; "unknown" while its owner writes it.
std::string process_in(int descriptor)
{
    std::array<char, 16> text{};
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
    std::string_view number{text.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
    number = number.substr(0, number.find_first_not_of("0123456789"));
    return number.empty() ? "unknown" : std::string{number};
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
    while (descriptor_ < 0) {
        const int descriptor =
            ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor < 0)
            fail_to("open", file_, errno);
        int error = 0;
        while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            error = errno;
            if (error != EINTR)
                break;
            error = 0;
        }
        if (error == 0 && is_still_there(descriptor, file_)) {
            descriptor_ = descriptor;
            break;
        }
        const std::string process = process_in(descriptor);
        ::close(descriptor);
        if (error == EWOULDBLOCK)
            refuse(folder, what, process);
        if (error != 0)
            fail_to("lock", file_, error);
    }
    const std::string number = std::to_string(::getpid()) + "\n";
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
