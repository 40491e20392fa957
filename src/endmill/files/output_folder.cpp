// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/output_folder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/files/read_file.h"

// Life of an output file:
//
// 1. `write_pieces` creates a hidden temporary file in the folder of the target, so that
//    the later rename stays within one file system and is atomic.
// 2. The content is written and flushed to the disk (fsync).
// 3. `publish` renames all temporary files to their targets, removes leftovers of an
//    earlier run, and flushes the folders.
//
// Every step first checks whether the process is being interrupted (`abandon_all`). The
// lists of all OutputFolders are guarded by one mutex in a registry of the process,
// because the thread that handles the interruption must be able to clean up all of them.

namespace endmill {
namespace {

namespace fs = std::filesystem;

// The unpublished OutputFolders of this process. The mutex guards the lists of all of
// them. It is not held while content is written, so an interruption need not wait for
// that.
struct Registry {
    std::mutex mutex;
    std::set<void*> folders;
    bool abandoned = false;
};

// The registry of this process.
Registry& registry()
{
    static auto* const instance =
        new Registry;  // never destroyed: threads may outlive main
    return *instance;
}

// Throws an OutputError with the reason of the operating system.
[[noreturn]] void fail(const std::string& act, const fs::path& path, int error)
{
    throw OutputError{"cannot " + act + " " + shown_path(path) + ": " +
                      std::generic_category().message(error)};
}

// Throws if the process is being interrupted. The caller holds the registry's mutex.
void require_not_abandoned()
{
    if (registry().abandoned)
        throw OutputError{"interrupted"};
}

// The access mode that the process gives to a new file, 0666 less its umask.
mode_t new_file_mode()
{
    static const mode_t mode = [] {
        const mode_t mask = ::umask(0);
        ::umask(mask);
        return 0666 & ~mask;
    }();
    return mode;
}

// While it exists, a write beyond the file size limit of the process returns an error;
// the signal SIGXFSZ, which would end the process, is blocked and discarded.
class SizeSignalHeld {
public:
    SizeSignalHeld()
    {
        sigemptyset(&signal_);
        sigaddset(&signal_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &signal_, &before_);
    }
    SizeSignalHeld(const SizeSignalHeld&) = delete;
    SizeSignalHeld& operator=(const SizeSignalHeld&) = delete;
    ~SizeSignalHeld()
    {
        const timespec no_wait{};
        while (sigtimedwait(&signal_, nullptr, &no_wait) == SIGXFSZ) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

private:
    sigset_t signal_{};
    sigset_t before_{};
};

// A newly created file. O_EXCL refuses an existing file and does not follow a symbolic
// link.
class NewFile {
public:
    explicit NewFile(const fs::path& path)
        : descriptor_{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)}
    {
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile()
    {
        if (is_open())
            ::close(descriptor_);
    }

    bool is_open() const { return descriptor_ >= 0; }

    // Appends to the file. \return 0, or the error number.
    int append(std::string_view content) const
    {
        const SizeSignalHeld held;
        while (!content.empty()) {
            const ssize_t count = ::write(descriptor_, content.data(), content.size());
            if (count < 0 && errno != EINTR)
                return errno;
            content.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        }
        return 0;
    }

    // Sets the usual access mode and flushes the file to the disk. \return 0, or the
    // error number.
    int finish() const
    {
        if (::fchmod(descriptor_, new_file_mode()) != 0 || ::fsync(descriptor_) != 0)
            return errno;
        return 0;
    }

private:
    int descriptor_;
};

// A hidden name in the folder of the target; the process number and a counter make it
// unique.
fs::path temporary_name(const fs::path& target)
{
    static std::atomic<unsigned> count = 0;
    const std::string name = "." + target.filename().string() + "." +
                             std::to_string(::getpid()) + "." + std::to_string(count++) +
                             ".tmp";
    return target.parent_path() / name;
}

// Flushes the folder, so that its renames survive a loss of power.
void flush_folder(const fs::path& folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;  // a folder without read permission cannot be flushed, only written to
    ::fsync(descriptor);
    ::close(descriptor);
}

// Checks an existing folder before anything is created.
void require_usable(const fs::path& path, FullFolder full)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        return;
    if (!fs::is_directory(status))
        throw DomainError{"output folder " + shown_path(path) +
                          " is a file; expected a new or empty folder"};
    const bool empty = fs::is_empty(path, error);
    if (error)
        fail("read the output folder", path, error.value());
    if (!empty && full == FullFolder::Refuse)
        throw DomainError{"output folder " + shown_path(path) +
                          " is not empty; expected a new or empty folder, or --force"};
}

// Refuses names that are absolute or lead out of the folder.
void require_plain_name(const fs::path& name)
{
    const bool plain = name.is_relative() && name.has_filename() &&
                       std::ranges::none_of(
                           name, [](const fs::path& p) { return p == "." || p == ".."; });
    if (!plain)
        throw DomainError{"OutputFolder: " + shown_path(name) +
                          " is not the name of a file in the folder"};
}

// Whether `name` lies in `folder` itself: no folder on its path is a symbolic link.
bool lies_inside(const fs::path& folder, const fs::path& name)
{
    std::error_code error;
    fs::path path = folder;
    for (const fs::path& part : name.parent_path()) {
        path /= part;
        if (!fs::is_directory(fs::symlink_status(path, error)))
            return false;
    }
    return true;
}

}  // namespace

// The folder registers itself before it creates anything, so that an interruption at any
// time can clean up.
OutputFolder::OutputFolder(fs::path path, FullFolder full) : path_{std::move(path)}
{
    require(!path_.empty(), "the output folder has an empty name");
    require_usable(path_, full);
    {
        const std::scoped_lock lock{registry().mutex};
        registry().folders.insert(this);
    }
    try {
        make_folders(path_);
        if (::faccessat(AT_FDCWD, path_.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
            fail("write to the output folder", path_, errno);
    } catch (...) {
        const std::scoped_lock lock{registry().mutex};
        registry().folders.erase(this);
        abandon();
        throw;
    }
}

// The destructor and `abandon_all` use the same mutex, so a folder is never cleaned up
// twice at once.
OutputFolder::~OutputFolder()
{
    const std::scoped_lock lock{registry().mutex};
    registry().folders.erase(this);
    abandon();
}

void OutputFolder::protect(const fs::path& input)
{
    inputs_.push_back(input);
}

void OutputFolder::remove_unless_written(const fs::path& name)
{
    require_plain_name(name);
    leftovers_.push_back(name);
}

void OutputFolder::write(const fs::path& name, std::string_view content)
{
    write_pieces(name, [&](const Sink& sink) { sink(content); });
}

// The mutex is released while the content is produced and written. The temporary file is
// in the list of pending files during this time, so an interruption removes it.
void OutputFolder::write_pieces(const fs::path& name,
                                const std::function<void(const Sink&)>& produce)
{
    require_plain_name(name);
    const fs::path target = path_ / name;
    check_target(target);
    make_folders(target.parent_path());

    std::unique_lock lock{registry().mutex};
    require_not_abandoned();
    const fs::path temporary = temporary_name(target);
    const NewFile file{temporary};
    if (!file.is_open())
        fail("write", target, errno);
    pending_.push_back({temporary, target});
    lock.unlock();
    const auto require_done = [&](int error) {
        if (error != 0)
            fail("write", target, error);
    };
    try {
        produce([&](std::string_view piece) { require_done(file.append(piece)); });
        require_done(file.finish());
    } catch (...) {
        lock.lock();
        forget(temporary);
        throw;
    }
    lock.lock();
    // The new file replaces an earlier one of the same name.
    std::erase_if(pending_, [&](const PendingFile& other) {
        const bool is_earlier = other.target == target && other.temporary != temporary;
        if (is_earlier)
            ::unlink(other.temporary.c_str());
        return is_earlier;
    });
}

// All renames happen under the mutex: an interruption comes before the first or after the
// last. A failed rename leaves the remaining files pending, and the destructor removes
// them.
void OutputFolder::publish()
{
    std::set<fs::path> folders;
    {
        const std::scoped_lock lock{registry().mutex};
        require_not_abandoned();
        while (!pending_.empty()) {
            const PendingFile& file = pending_.front();
            if (::rename(file.temporary.c_str(), file.target.c_str()) != 0)
                fail("write", file.target, errno);
            folders.insert(file.target.parent_path());
            std::erase_if(leftovers_, [&](const fs::path& name) {
                return path_ / name == file.target;
            });
            pending_.erase(pending_.begin());
        }
        created_folders_.clear();
        for (const fs::path& name : leftovers_)
            remove_leftover(name);
        leftovers_.clear();
    }
    std::ranges::for_each(folders, flush_folder);
}

void OutputFolder::abandon_all()
{
    const std::scoped_lock lock{registry().mutex};
    registry().abandoned = true;
    // The files are only unlinked: threads that are writing continue on unnamed files.
    for (void* folder : registry().folders)
        static_cast<OutputFolder*>(folder)->abandon();
}

// Creates the missing folders of a path, the outermost first.
void OutputFolder::make_folders(const fs::path& folder)
{
    std::error_code error;
    std::vector<fs::path> missing;
    for (fs::path path = folder; !path.empty() && !fs::exists(path, error);
         path = path.parent_path())
        missing.push_back(path);
    const std::scoped_lock lock{registry().mutex};
    require_not_abandoned();
    // Folders are created one by one, so that exactly the created ones can be removed.
    while (!missing.empty()) {
        const int failure = ::mkdir(missing.back().c_str(), 0777) == 0 ? 0 : errno;
        if (failure == 0)
            created_folders_.push_back(missing.back());
        else if (!fs::is_directory(missing.back(), error))
            fail("create the output folder", missing.back(), failure);
        missing.pop_back();
    }
}

// The caller holds the registry's mutex.
void OutputFolder::forget(const fs::path& temporary)
{
    ::unlink(temporary.c_str());
    std::erase_if(pending_,
                  [&](const PendingFile& file) { return file.temporary == temporary; });
}

// Refuses a target that is a folder or a protected input.
void OutputFolder::check_target(const fs::path& target) const
{
    std::error_code error;
    if (fs::is_directory(target, error))
        fail("write", target, EISDIR);
    if (is_input(target))
        throw DomainError{"output " + shown_path(target) +
                          " is the input file; expected another output folder"};
}

// Inputs are compared by identity of the file and not by path, so links are recognised.
bool OutputFolder::is_input(const fs::path& target) const
{
    std::error_code error;
    return std::ranges::any_of(inputs_, [&](const fs::path& input) {
        return fs::equivalent(target, input, error);
    });
}

// Removes a file of an earlier run if it is a plain file below the folder.
void OutputFolder::remove_leftover(const fs::path& name) const
{
    std::error_code error;
    const fs::path target = path_ / name;
    const bool is_ours = lies_inside(path_, name) &&
                         fs::is_regular_file(fs::symlink_status(target, error)) &&
                         !is_input(target);
    if (!is_ours)
        return;
    if (::unlink(target.c_str()) != 0)
        fail("remove", target, errno);
    if (name.has_parent_path())
        ::rmdir(target.parent_path().c_str());  // fails if the folder is not empty
}

// The caller holds the registry's mutex.
void OutputFolder::abandon()
{
    for (const PendingFile& file : pending_)
        ::unlink(file.temporary.c_str());
    for (auto folder = created_folders_.rbegin(); folder != created_folders_.rend();
         ++folder)
        ::rmdir(folder->c_str());
    pending_.clear();
    created_folders_.clear();
}

void write_file(const fs::path& path, std::string_view content)
{
    const fs::path folder = path.parent_path();
    OutputFolder output{folder.empty() ? fs::path{"."} : folder, FullFolder::Accept};
    output.write(path.filename(), content);
    output.publish();
}

}  // namespace endmill
