// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/staging_folder.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <exception>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/files/detail/output_path.h"

namespace endmill {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".endmill-";
constexpr std::string_view suffix = ".tmp";
// s, after which a folder without a lock belongs to no process that is about to lock it.
constexpr std::time_t locking_time_s = 10;

// The process number in ".endmill-PROCESS-COUNT.tmp"; nothing for another name.
std::optional<pid_t> process_of(const std::string& name)
{
    if (!name.starts_with(prefix) || !name.ends_with(suffix))
        return std::nullopt;
    const std::string_view numbers = std::string_view{name}.substr(
        prefix.size(), name.size() - prefix.size() - suffix.size());
    const std::size_t dash = numbers.find('-');
    constexpr std::size_t most_digits = 10;
    const auto is_number = [](std::string_view text) {
        return !text.empty() && text.size() <= most_digits &&
               text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (dash == std::string_view::npos || !is_number(numbers.substr(0, dash)) ||
        !is_number(numbers.substr(dash + 1)))
        return std::nullopt;
    return static_cast<pid_t>(std::stoll(std::string{numbers.substr(0, dash)}));
}

// Whether a process has ended and only waits for its parent to notice, which may take long if
// its own parent was killed.
bool has_ended(pid_t process)
{
    std::ifstream file{"/proc/" + std::to_string(process) + "/stat"};
    std::string text;
    std::getline(file, text);
    const std::size_t name_end = text.rfind(") ");  // the name may have any letters
    const char state = name_end + 2 < text.size() && name_end != std::string::npos
                           ? text[name_end + 2]
                           : ' ';
    return state == 'Z' || state == 'X';
}

// The lock of a folder. Not all file systems have locks.
bool is_without_locks(int error)
{
    return error == EOPNOTSUPP || error == ENOLCK || error == ENOSYS || error == EINVAL;
}

}  // namespace

bool is_at_work(pid_t process)
{
    return (::kill(process, 0) == 0 || errno == EPERM) && !has_ended(process);
}

bool is_staging_name(const fs::path& name)
{
    return process_of(name.filename().string()).has_value();
}

void remove_staging(const fs::path& staging)
{
    std::error_code error;
    fs::remove_all(staging / "old", error);
    if (!error)
        fs::remove_all(staging, error);
}

Abandoned lock_of_abandoned(const fs::path& path)
{
    const pid_t process = process_of(path.filename().string()).value();
    const int lock =
        ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (lock < 0)
        return {errno == ENOENT || errno == ENOTDIR || errno == ELOOP, -1};
    struct stat status {};
    const bool is_locked = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
    const bool is_held = !is_locked && errno == EWOULDBLOCK;
    // A process locks its folder at once. Without the lock it has the number of another
    // one that is gone.
    const bool is_old = is_locked && ::fstat(lock, &status) == 0 &&
                        std::time(nullptr) - status.st_mtime > locking_time_s;
    const bool lives = process != ::getpid() && is_at_work(process);
    if (!is_held && (is_old || !lives))
        return {true, lock};
    ::close(lock);
    return {};
}

StagingFolder::StagingFolder(const fs::path& place, const fs::path& shown)
{
    static std::atomic<unsigned> count = 0;
    fs::path path = place / (std::string{prefix} + std::to_string(::getpid()) + '-' +
                             std::to_string(count++) + std::string{suffix});
    if (::mkdir(path.c_str(), 0777) != 0)
        fail_output("write to the output folder", shown, errno);
    path_ = std::move(path);
    lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int error = lock_ < 0 ? errno : 0;
    // Another run may hold the lock for a moment to find out who owns the folder.
    while (error == 0 && ::flock(lock_, LOCK_EX) != 0)
        if (errno != EINTR)
            error = errno;
    if (error != 0 && !is_without_locks(error)) {
        remove();
        fail_output("lock the output folder", shown, error);
    }
}

StagingFolder::StagingFolder(StagingFolder&& other) noexcept
    : path_{std::exchange(other.path_, {})},
      lock_{std::exchange(other.lock_, -1)}
{
}

StagingFolder& StagingFolder::operator=(StagingFolder&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(lock_, other.lock_);
    return *this;
}

StagingFolder::~StagingFolder()
{
    remove();
}

void StagingFolder::release()
{
    path_.clear();
    if (lock_ >= 0)
        ::close(std::exchange(lock_, -1));
}

void StagingFolder::remove() noexcept
{
    try {
        if (!path_.empty())
            remove_staging(path_);
    } catch (const std::exception&) {
        release();  // no memory; the next run removes the folder
        return;
    }
    release();
}

}  // namespace endmill
