// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/staging_folder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
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

// The values of Fate.
constexpr std::string_view fates = "nord";

bool is_summary(const fs::path& name)
{
    return name.filename() == "summary.json";
}

// Whether there is a file or folder of this name.
enum class Presence { Absent, Present, Unknown };

Presence presence(const fs::path& path)
{
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0)
        return Presence::Present;
    return errno == ENOENT || errno == ENOTDIR ? Presence::Absent : Presence::Unknown;
}

bool is_there(const fs::path& path)
{
    return presence(path) == Presence::Present;
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

// The lock of a folder. Not all file systems have locks.
bool is_without_locks(int error)
{
    return error == EOPNOTSUPP || error == ENOLCK || error == ENOSYS || error == EINVAL;
}

// A staging folder of a process that may be gone.
struct Abandoned {
    bool is_known = true;  // whether it could be found out
    int lock = -1;         // descriptor; -1 if its process lives, or it is no folder
};

Abandoned lock_of_abandoned(const fs::path& path, pid_t process)
{
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
    const bool lives =
        process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);
    if (!is_held && (is_old || !lives))
        return {true, lock};
    ::close(lock);
    return {};
}

// The content of a file; nothing if it cannot be read.
std::optional<std::string> content(const fs::path& file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0)
        return std::nullopt;
    std::string text;
    std::array<char, 4096> piece;
    ssize_t count = 0;
    do {
        count = ::read(descriptor, piece.data(), piece.size());
        if (count > 0)
            text.append(piece.data(), static_cast<std::size_t>(count));
    } while (count > 0 || (count < 0 && errno == EINTR));
    ::close(descriptor);
    return count == 0 ? std::optional{text} : std::nullopt;
}

// Removes a staging folder whose changes are complete or undone. The journal goes after the
// old files, which nobody could put back without it.
void remove_staging(const fs::path& staging)
{
    std::error_code error;
    fs::remove_all(staging / "old", error);
    if (!error)
        fs::remove_all(staging, error);
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

// What a change does to a file or a folder. It is the first character of an entry of the
// journal. Entries end with a zero byte, which no file name contains.
enum class FolderChange::Fate : char {
    New = 'n',       // a new file where there was none
    Replaced = 'o',  // a new file in place of an old one
    Removed = 'r',   // an old file that goes
    Folder = 'd'     // a new folder
};
struct FolderChange::Entry {
    Fate fate;
    fs::path name;
};

int write_whole(int descriptor, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno != EINTR)
            return errno;
        content.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return 0;
}

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
        if (fs::is_directory(path, ignored) || ::mkdir(path.c_str(), 0777) == 0)
            continue;
        const int error = errno;
        if (error != EEXIST)
            return error;
        if (!fs::is_directory(path, ignored))  // else another run has just created it
            return ENOTDIR;
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

FolderChange::FolderChange(fs::path folder, fs::path staging)
    : folder_{std::move(folder)},
      staging_{std::move(staging)}
{
}

void FolderChange::make(const std::vector<fs::path>& written,
                        const std::vector<fs::path>& removed, StagingFolder& staging)
{
    const Journal journal = journal_of(written, removed);
    if (journal.size() == 1 && written.size() == 1)
        return publish(written[0]);  // one rename makes the change
    write(journal, staging_ / "names");
    if (::mkdir((staging_ / "old").c_str(), 0777) != 0)
        fail_output("write to the output folder", folder_, errno);
    try {
        std::vector<fs::path> old;  // the summary of the whole result first
        for (auto entry = journal.rbegin(); entry != journal.rend(); ++entry)
            if (entry->fate == Fate::Replaced || entry->fate == Fate::Removed)
                old.push_back(entry->name);
        std::stable_partition(old.begin(), old.end(), is_summary);
        for (const fs::path& name : old)
            move_away(name);
        for (const Entry& entry : journal)
            if (entry.fate == Fate::New || entry.fate == Fate::Replaced)
                publish(entry.name);
    } catch (...) {
        // What cannot be taken back now stays for the next run.
        if (!undo())
            staging.release();
        throw;
    }
    for (const fs::path& name : removed)
        remove_empty_parents(folder_, name);
}

// The new files in the order in which they are published, summaries last; then the files
// that are removed and the folders that are missing, inner ones first.
FolderChange::Journal FolderChange::journal_of(const std::vector<fs::path>& written,
                                               const std::vector<fs::path>& removed) const
{
    std::vector<fs::path> order = written;
    std::ranges::stable_sort(order, {}, [](const fs::path& name) {
        return !is_summary(name) ? 0 : name.has_parent_path() ? 1 : 2;
    });
    Journal journal;
    std::set<fs::path> folders;
    for (const fs::path& name : order) {
        const Presence old = presence(folder_ / name);
        if (old == Presence::Unknown)
            fail_output("replace", folder_ / name, errno);
        journal.push_back({old == Presence::Present ? Fate::Replaced : Fate::New, name});
        for (fs::path parent = name.parent_path(); !parent.empty();
             parent = parent.parent_path())
            if (!is_there(folder_ / parent))
                folders.insert(parent);
    }
    for (const fs::path& name : removed)
        if (is_there(folder_ / name))
            journal.push_back({Fate::Removed, name});
    for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
        journal.push_back({Fate::Folder, *folder});
    return journal;
}

void FolderChange::write(const Journal& journal, const fs::path& file)
{
    std::string text;
    for (const Entry& entry : journal)
        text += static_cast<char>(entry.fate) + entry.name.string() + '\0';
    const int descriptor =
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    int error = descriptor < 0 ? errno : write_whole(descriptor, text);
    if (error == 0 && ::fsync(descriptor) != 0)
        error = errno;
    if (descriptor >= 0)
        ::close(descriptor);
    if (error != 0)
        fail_output("write", file, error);
}

// Returns nothing if the file cannot be read, or holds what `write` does not write: anybody
// may have changed it.
std::optional<FolderChange::Journal> FolderChange::journal_in(const fs::path& file)
{
    const std::optional<std::string> text = content(file);
    if (!text || text->empty() || text->back() != '\0')
        return std::nullopt;
    Journal journal;
    std::size_t begin = 0;
    for (std::size_t end = text->find('\0'); end != std::string::npos;
         begin = end + 1, end = text->find('\0', begin)) {
        const std::string entry = text->substr(begin, end - begin);
        if (entry.empty() || fates.find(entry[0]) == std::string_view::npos ||
            !is_plain_name(entry.substr(1)))
            return std::nullopt;
        journal.push_back({static_cast<Fate>(entry[0]), entry.substr(1)});
    }
    return journal;
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

bool FolderChange::is_complete(const Journal& journal) const
{
    return std::ranges::all_of(journal, [&](const Entry& entry) {
        return entry.fate == Fate::Removed || entry.fate == Fate::Folder ||
               presence(staging_ / "new" / entry.name) == Presence::Absent;
    });
}

bool FolderChange::undo()
{
    const Presence old = presence(staging_ / "old");
    if (old == Presence::Absent)
        return true;  // nothing was changed yet
    const std::optional<Journal> journal = journal_in(staging_ / "names");
    if (old == Presence::Unknown || !journal)
        return false;
    if (is_complete(*journal))
        return true;
    bool is_undone = true;
    for (const Entry& entry : *journal)
        is_undone = undo(entry) && is_undone;
    return is_undone;
}

// Takes the old file back. A new file where there was none returns to the new ones.
bool FolderChange::undo(const Entry& entry)
{
    const fs::path place = folder_ / entry.name;
    if (entry.fate == Fate::Folder) {
        ::rmdir(place.c_str());  // unless somebody has put something there
        return true;
    }
    const fs::path kept = staging_ / "old" / entry.name;
    const fs::path unpublished = staging_ / "new" / entry.name;
    const Presence old = presence(kept);
    if (old == Presence::Present)
        return lies_inside(staging_ / "old", entry.name) &&
               make_folders(folder_, entry.name) == 0 &&
               ::rename(kept.c_str(), place.c_str()) == 0;
    if (old == Presence::Absent && entry.fate != Fate::New)
        return true;  // it is back, or was never moved
    const Presence fresh = presence(unpublished);
    if (old == Presence::Absent && fresh == Presence::Absent &&
        lies_inside(folder_, entry.name) && is_there(place))
        return make_folders(staging_ / "new", entry.name) == 0 &&
               ::rename(place.c_str(), unpublished.c_str()) == 0;
    return old == Presence::Absent && fresh != Presence::Unknown;
}

fs::path clear_abandoned_runs(const fs::path& folder)
{
    std::error_code error;
    std::set<fs::path> found;
    for (auto entry =
             fs::directory_iterator{folder, fs::directory_options::skip_permission_denied,
                                    error};
         !error && entry != fs::directory_iterator{}; entry.increment(error))
        if (is_staging_name(entry->path()))
            found.insert(entry->path());
    fs::path left;
    for (const fs::path& staging : found) {
        const auto [is_known, lock] =
            lock_of_abandoned(staging, *process_of(staging.filename().string()));
        if (lock >= 0 && FolderChange{folder, staging}.undo())
            remove_staging(staging);
        else if (lock >= 0 || !is_known)
            left = staging;
        if (lock >= 0)
            ::close(lock);
    }
    return left;
}

}  // namespace endmill
