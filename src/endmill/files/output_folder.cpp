// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/output_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <memory>
#include <mutex>
#include <new>
#include <set>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/files/detail/folder_change.h"
#include "endmill/files/detail/output_path.h"
#include "endmill/files/detail/staging_folder.h"
#include "endmill/files/read_file.h"

// Life of an output file:
//
// 1. `write_pieces` creates it in the staging folder, which lies in the same file system as
//    its final place, writes it and flushes it to the disk (fsync).
// 2. `publish` renames the staging folder to the output folder if there is none yet. Else
//    it moves the files, as a change that can be undone (FolderChange).
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

// The registry of this process. It needs no memory of the heap, and is never destroyed:
// threads may outlive main.
Registry& registry()
{
    alignas(Registry) static std::array<std::byte, sizeof(Registry)> memory;
    static auto* const instance = new (memory.data()) Registry;
    return *instance;
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
    int append(std::string_view content)
    {
        const SizeSignalHeld held;
        if (const int error = write_whole(descriptor_, content); error != 0)
            return error;
        bytes_ += content.size();
        start_flush();
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
    // Lets the disk write while the next pieces are made, so that `finish` waits for little.
    // `finish` reports the errors of the disk.
    void start_flush()
    {
#ifdef SYNC_FILE_RANGE_WRITE
        if (bytes_ - flushed_bytes_ < bytes_a_flush)
            return;
        ::sync_file_range(descriptor_, static_cast<off_t>(flushed_bytes_),
                          static_cast<off_t>(bytes_ - flushed_bytes_),
                          SYNC_FILE_RANGE_WRITE);
        flushed_bytes_ = bytes_;
#endif
    }

    // Large enough for the full speed of a disk, and small beside the memory for dirty pages.
    static constexpr std::size_t bytes_a_flush = std::size_t{1} << 25U;

    int descriptor_;
    std::size_t bytes_ = 0;
    std::size_t flushed_bytes_ = 0;
};

// Flushes the folder, so that its renames survive a loss of power.
void flush_folder(const fs::path& folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;  // a folder without read permission cannot be flushed, only written to
    ::fsync(descriptor);
    ::close(descriptor);
}

// Checks the folder before anything is created. \return whether it exists.
bool require_usable(const fs::path& path, FullFolder full)
{
    std::error_code error;
    const fs::file_status link = fs::symlink_status(path, error);
    if (link.type() == fs::file_type::none)
        fail_output("create the output folder", path, error.value());
    const fs::file_status status = fs::status(path, error);
    if (fs::is_symlink(link) && !fs::exists(status))
        throw OutputError{
            "cannot create the output folder " + shown_path(path) + ": it is a link to " +
            shown_path(fs::read_symlink(path, error)) +
            (status.type() == fs::file_type::not_found ? ", which does not exist"
                                                       : ", which cannot be followed")};
    if (!fs::exists(status))
        return false;
    if (!fs::is_directory(status))
        throw DomainError{"output folder " + shown_path(path) +
                          " is a file; expected a new or empty folder"};
    if (const fs::path left = clear_abandoned_runs(path); !left.empty())
        throw OutputError{"cannot restore the output folder " + shown_path(path) +
                          " after a run that was killed; " + shown_path(left) +
                          " holds its old and new files"};
    const bool empty = fs::is_empty(path, error);
    if (error)
        fail_output("read the output folder", path, error.value());
    if (!empty && full == FullFolder::Refuse)
        throw DomainError{"output folder " + shown_path(path) +
                          " is not empty; expected a new or empty folder, or --force"};
    return true;
}

// Refuses names that are absolute or lead out of the folder.
void require_plain_name(const fs::path& name)
{
    if (!is_plain_name(name))
        throw DomainError{"OutputFolder: " + shown_path(name) +
                          " is not the name of a file in the folder"};
}

}  // namespace

struct OutputFolder::Staging {
    StagingFolder folder;
    bool is_result = false;  // it becomes the output folder
    unsigned parts = 0;      // files that were begun
};

// The folder registers itself and creates its staging folder under the mutex: an
// interruption comes before or after both, and cleans up what there is.
OutputFolder::OutputFolder(fs::path path, FullFolder full) : path_{std::move(path)}
{
    require(!path_.empty(), "the output folder has an empty name");
    const bool is_present = require_usable(path_, full);
    const std::scoped_lock lock{registry().mutex};
    require_not_abandoned();
    registry().folders.insert(this);
    try {
        if (!is_present)
            make_parents();
        make_staging();
    } catch (...) {
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
    to_be_removed_.push_back(name);
}

void OutputFolder::write(const fs::path& name, std::string_view content)
{
    write_pieces(name, [&](const Sink& sink) { sink(content); });
}

// The mutex is released while the content is produced and written. A file becomes a part of
// the result when it is complete, so one that fails keeps an earlier one of its name.
void OutputFolder::write_pieces(const fs::path& name,
                                const std::function<void(const Sink&)>& produce)
{
    require_plain_name(name);
    const fs::path target = path_ / name;
    check_target(target);
    std::unique_lock lock{registry().mutex};
    require_not_abandoned();
    if (!staging_)
        make_staging();
    const fs::path place = place_of_files();
    const fs::path part =
        staging_->folder.path() / (".part-" + std::to_string(staging_->parts++));
    NewFile file{part};
    if (!file.is_open())
        fail_output("write", target, errno);
    lock.unlock();
    const auto require_done = [&](int error) {
        if (error != 0)
            fail_output("write", target, error);
    };
    try {
        produce([&](std::string_view piece) { require_done(file.append(piece)); });
        require_done(file.finish());
    } catch (...) {
        ::unlink(part.c_str());
        throw;
    }
    lock.lock();
    require_not_abandoned();
    require_done(make_folders(place, name));
    require_done(::rename(part.c_str(), (place / name).c_str()) == 0 ? 0 : errno);
    if (std::ranges::find(written_, name) == written_.end())
        written_.push_back(name);
}

// All changes happen under the mutex: an interruption comes before or after them.
void OutputFolder::publish()
{
    const std::scoped_lock lock{registry().mutex};
    require_not_abandoned();
    if (!staging_)
        return;
    if (staging_->is_result) {
        const fs::path target = path_.has_filename() ? path_ : path_.parent_path();
        flush_folder(staging_->folder.path());
        if (::rename(staging_->folder.path().c_str(), target.c_str()) != 0)
            fail_output("create the output folder", path_, errno);
        staging_->folder.release();
        flush_folder(target.parent_path());
    } else {
        FolderChange{path_, staging_->folder.path()}.make(written_, leftovers(),
                                                          staging_->folder);
        std::set<fs::path> folders;
        for (const fs::path& name : written_)
            folders.insert((path_ / name).parent_path());
        std::ranges::for_each(folders, flush_folder);
    }
    staging_.reset();
    created_folders_.clear();
    written_.clear();
    to_be_removed_.clear();
}

void OutputFolder::abandon_all()
{
    const std::scoped_lock lock{registry().mutex};
    abandon_each();
}

void OutputFolder::abandon_all_unless_busy()
{
    const std::unique_lock lock{registry().mutex, std::try_to_lock};
    if (lock)
        abandon_each();
}

// The caller holds the registry's mutex. The files are only unlinked: threads that are
// writing continue on unnamed files.
void OutputFolder::abandon_each()
{
    registry().abandoned = true;
    for (void* folder : registry().folders)
        static_cast<OutputFolder*>(folder)->abandon();
}

// Creates the missing folders above the output folder, the outermost first. They are created
// one by one, so that exactly the created ones can be removed. The caller holds the
// registry's mutex.
void OutputFolder::make_parents()
{
    std::error_code error;
    std::vector<fs::path> missing;
    const fs::path folder = path_.has_filename() ? path_ : path_.parent_path();
    for (fs::path path = folder.parent_path(); !path.empty() && !fs::exists(path, error);
         path = path.parent_path())
        missing.push_back(path);
    while (!missing.empty()) {
        const int failure = ::mkdir(missing.back().c_str(), 0777) == 0 ? 0 : errno;
        if (failure == 0)
            created_folders_.push_back(missing.back());
        else if (!fs::is_directory(missing.back(), error))
            fail_output("create the output folder", missing.back(),
                        failure == EEXIST ? ENOTDIR : failure);  // a link to nowhere
        missing.pop_back();
    }
}

// The staging folder of a new output folder lies beside it, and that of an existing one in
// it. The caller holds the registry's mutex.
void OutputFolder::make_staging()
{
    std::error_code error;
    auto staging = std::make_unique<Staging>();
    staging->is_result = !fs::exists(path_, error);
    fs::path place = path_;
    if (staging->is_result) {
        place = (path_.has_filename() ? path_ : path_.parent_path()).parent_path();
        if (place.empty())
            place = ".";
        clear_abandoned_runs(place);  // those of other folders do not matter
    }
    staging->folder = StagingFolder{place, path_};
    const fs::path files = staging->folder.path() / "new";
    if (!staging->is_result && ::mkdir(files.c_str(), 0777) != 0)
        fail_output("write to the output folder", path_, errno);
    staging_ = std::move(staging);
}

fs::path OutputFolder::place_of_files() const
{
    const fs::path& folder = staging_->folder.path();
    return staging_->is_result ? folder : folder / "new";
}

// Refuses a target that is a folder or a protected input.
void OutputFolder::check_target(const fs::path& target) const
{
    std::error_code error;
    if (fs::is_directory(target, error))
        fail_output("write", target, EISDIR);
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

// The plain files below the folder that an earlier run left.
std::vector<fs::path> OutputFolder::leftovers() const
{
    std::vector<fs::path> found;
    for (const fs::path& name : to_be_removed_) {
        std::error_code error;
        const fs::path target = path_ / name;
        if (std::ranges::find(written_, name) == written_.end() &&
            lies_inside(path_, name) &&
            fs::is_regular_file(fs::symlink_status(target, error)) && !is_input(target))
            found.push_back(name);
    }
    return found;
}

// The caller holds the registry's mutex.
void OutputFolder::abandon()
{
    staging_.reset();
    for (auto folder = created_folders_.rbegin(); folder != created_folders_.rend();
         ++folder)
        ::rmdir(folder->c_str());
    created_folders_.clear();
    written_.clear();
}

void write_file(const fs::path& path, std::string_view content)
{
    const fs::path folder = path.parent_path();
    OutputFolder output{folder.empty() ? fs::path{"."} : folder, FullFolder::Accept};
    output.write(path.filename(), content);
    output.publish();
}

}  // namespace endmill
