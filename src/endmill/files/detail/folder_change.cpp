// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/folder_change.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/files/detail/output_path.h"

namespace endmill {

namespace fs = std::filesystem;

namespace {

// The values of Fate.
constexpr std::string_view fates = "nord";

bool is_summary(const fs::path& name)
{
    return name.filename() == "summary.json";
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
        const auto [is_known, lock] = lock_of_abandoned(staging);
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
