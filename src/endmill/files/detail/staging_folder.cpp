// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/staging_folder.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"

namespace endmill {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".endmill-";
constexpr std::string_view suffix = ".tmp";
// s, after which a folder without a lock belongs to no process that is about to lock it.
constexpr std::time_t locking_time_s = 10;

// The names of a change, each with what is done to it, end with a zero byte, which no file
// name contains.
constexpr char written_mark = 'w';
constexpr char removed_mark = 'r';

bool is_summary(const fs::path& name)
{
    return name.filename() == "summary.json";
}

bool is_there(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

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

// Locks a folder. \return a descriptor, or -1 if its process lives or it is no folder.
int lock_of_abandoned(const fs::path& path, pid_t process)
{
    const int lock =
        ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (lock < 0)
        return -1;
    struct stat status {};
    const bool is_locked = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
    const bool is_held = !is_locked && errno == EWOULDBLOCK;
    const bool is_old = is_locked && ::fstat(lock, &status) == 0 &&
                        std::time(nullptr) - status.st_mtime > locking_time_s;
    const bool lives =
        process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);
    if (!is_held && (is_old || !lives))
        return lock;
    ::close(lock);
    return -1;
}

// The parts of a change, as they stand in its file of names.
struct Names {
    std::vector<fs::path> written;
    std::vector<fs::path> removed;
};

// Names that lead out of the folder are left out: anybody may have written the file.
Names read_names(const fs::path& file)
{
    std::ifstream stream{file, std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{stream}, {}};
    Names names;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\0'); end != std::string::npos;
         begin = end + 1, end = text.find('\0', begin)) {
        const std::string entry = text.substr(begin, end - begin);
        if (entry.empty() || !is_plain_name(entry.substr(1)))
            continue;
        if (entry[0] == written_mark)
            names.written.emplace_back(entry.substr(1));
        else if (entry[0] == removed_mark)
            names.removed.emplace_back(entry.substr(1));
    }
    return names;
}

void write_names(const fs::path& file, const Names& names)
{
    std::string text;
    for (const fs::path& name : names.written)
        text += written_mark + name.string() + '\0';
    for (const fs::path& name : names.removed)
        text += removed_mark + name.string() + '\0';
    const int descriptor =
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    int error = descriptor < 0 ? errno : 0;
    for (std::string_view rest = text; error == 0 && !rest.empty();) {
        const ssize_t count = ::write(descriptor, rest.data(), rest.size());
        if (count < 0 && errno != EINTR)
            error = errno;
        rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    if (error == 0 && ::fsync(descriptor) != 0)
        error = errno;
    if (descriptor >= 0)
        ::close(descriptor);
    if (error != 0)
        fail_output("write", file, error);
}

// Removes the folders of `name` below `folder`, as far as they are empty.
void remove_empty_parents(const fs::path& folder, const fs::path& name)
{
    for (fs::path parent = name.parent_path(); !parent.empty();
         parent = parent.parent_path())
        if (::rmdir((folder / parent).c_str()) != 0)
            return;
}

}  // namespace

void fail_output(const std::string& act, const fs::path& path, int error)
{
    throw OutputError{"cannot " + act + " " + shown_path(path) + ": " +
                      std::generic_category().message(error)};
}

bool is_plain_name(const fs::path& name)
{
    return name.is_relative() && name.has_filename() &&
           std::ranges::none_of(
               name, [](const fs::path& part) { return part == "." || part == ".."; });
}

bool lies_inside(const fs::path& folder, const fs::path& name)
{
    std::error_code ignored;
    fs::path path = folder;
    for (const fs::path& part : name.parent_path()) {
        path /= part;
        if (!fs::is_directory(fs::symlink_status(path, ignored)))
            return false;
    }
    return true;
}

int make_folders(const fs::path& folder, const fs::path& name)
{
    std::error_code ignored;
    fs::path path = folder;
    for (const fs::path& part : name.parent_path()) {
        path /= part;
        if (!fs::is_directory(path, ignored) && ::mkdir(path.c_str(), 0777) != 0 &&
            errno != EEXIST)
            return errno;
    }
    return 0;
}

bool is_staging_name(const fs::path& name)
{
    return process_of(name.filename().string()).has_value();
}

StagingFolder::StagingFolder(const fs::path& place, const fs::path& shown)
{
    static std::atomic<unsigned> count = 0;
    fs::path path = place / (std::string{prefix} + std::to_string(::getpid()) + '-' +
                             std::to_string(count++) + std::string{suffix});
    if (::mkdir(path.c_str(), 0777) != 0)
        fail_output("write to the output folder", shown, errno);
    path_ = std::move(path);
    // Not all file systems have locks. There the process number tells who lives.
    lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ >= 0)
        static_cast<void>(::flock(lock_, LOCK_EX | LOCK_NB));
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
        std::error_code ignored;
        if (!path_.empty())
            fs::remove_all(path_, ignored);
    } catch (const std::exception&) {
        release();  // no memory; the next run removes the folder
        return;
    }
    release();
}

FolderChange::FolderChange(fs::path folder, fs::path staging)
    : folder_{std::move(folder)},
      staging_{std::move(staging)}
{
}

void FolderChange::make(const std::vector<fs::path>& written,
                        const std::vector<fs::path>& removed, StagingFolder& staging)
{
    std::vector<fs::path> order = written;
    std::ranges::stable_sort(order, {}, [](const fs::path& name) {
        return !is_summary(name) ? 0 : name.has_parent_path() ? 1 : 2;
    });
    if (order.size() == 1 && removed.empty())
        return publish(order[0]);  // one rename makes the change
    write_names(staging_ / "names", {order, removed});
    if (::mkdir((staging_ / "old").c_str(), 0777) != 0)
        fail_output("write to the output folder", folder_, errno);
    try {
        std::vector<fs::path> old = order;
        std::ranges::reverse(old);
        old.insert(old.end(), removed.begin(), removed.end());
        std::stable_partition(old.begin(), old.end(), is_summary);
        for (const fs::path& name : old)
            if (is_there(folder_ / name))
                move_away(name);
        for (const fs::path& name : order)
            publish(name);
    } catch (...) {
        // What cannot be taken back now stays for the next run.
        if (!undo())
            staging.release();
        throw;
    }
    for (const fs::path& name : removed)
        remove_empty_parents(folder_, name);
}

void FolderChange::move_away(const fs::path& name)
{
    const fs::path from = folder_ / name;
    const int error = make_folders(staging_ / "old", name);
    if (error != 0 || ::rename(from.c_str(), (staging_ / "old" / name).c_str()) != 0)
        fail_output("replace", from, error != 0 ? error : errno);
}

void FolderChange::publish(const fs::path& name)
{
    const fs::path target = folder_ / name;
    const int error = make_folders(folder_, name);
    if (error != 0 || ::rename((staging_ / "new" / name).c_str(), target.c_str()) != 0)
        fail_output("write", target, error != 0 ? error : errno);
}

bool FolderChange::is_complete(const std::vector<fs::path>& written) const
{
    return std::ranges::none_of(
        written, [&](const fs::path& name) { return is_there(staging_ / "new" / name); });
}

bool FolderChange::undo()
{
    const Names names = read_names(staging_ / "names");
    if (is_complete(names.written))
        return true;
    bool is_undone = true;
    const auto take_back = [&](const fs::path& name) {
        const fs::path kept = staging_ / "old" / name;
        if (!lies_inside(staging_ / "old", name) || !is_there(kept))
            return false;
        if (make_folders(folder_, name) != 0 ||
            ::rename(kept.c_str(), (folder_ / name).c_str()) != 0)
            is_undone = false;
        return true;
    };
    // The summary is taken back last.
    for (auto name = names.written.begin(); name != names.written.end(); ++name) {
        const bool is_published = !is_there(staging_ / "new" / *name);
        if (!take_back(*name) && is_published && lies_inside(folder_, *name)) {
            ::unlink((folder_ / *name).c_str());
            remove_empty_parents(folder_, *name);
        }
    }
    std::ranges::for_each(names.removed, take_back);
    return is_undone;
}

void clear_abandoned_runs(const fs::path& folder)
{
    std::error_code error;
    std::set<fs::path> found;
    for (auto entry =
             fs::directory_iterator{folder, fs::directory_options::skip_permission_denied,
                                    error};
         !error && entry != fs::directory_iterator{}; entry.increment(error))
        if (is_staging_name(entry->path()))
            found.insert(entry->path());
    for (const fs::path& staging : found) {
        const int lock =
            lock_of_abandoned(staging, *process_of(staging.filename().string()));
        if (lock < 0)
            continue;
        if (FolderChange{folder, staging}.undo())
            fs::remove_all(staging, error);
        ::close(lock);
    }
}

}  // namespace endmill
