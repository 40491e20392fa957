// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include <sys/types.h>

namespace endmill {

/// A hidden folder that holds the files of an unfinished run. It is locked as long as its
/// process lives, so that later runs can tell whether they may remove it.
class StagingFolder {
public:
    StagingFolder() = default;  ///< none

    /// Creates the folder in `place`. \throws OutputError that names `shown` and the reason.
    StagingFolder(const std::filesystem::path& place, const std::filesystem::path& shown);

    ~StagingFolder();  ///< removes the folder and all its files
    StagingFolder(const StagingFolder&) = delete;             ///< one folder, one owner
    StagingFolder& operator=(const StagingFolder&) = delete;  ///< not assignable either
    StagingFolder(StagingFolder&& other) noexcept;
    StagingFolder& operator=(StagingFolder&& other) noexcept;

    /// The folder; empty if there is none.
    const std::filesystem::path& path() const { return path_; }

    /// Gives up ownership: the folder stays, unlocked.
    void release();

    /// Removes the folder and all its files, as far as possible.
    void remove() noexcept;

private:
    std::filesystem::path path_;
    int lock_ = -1;  // descriptor of the folder
};

/// Whether a process of this number exists and has not ended. One that waits for its parent to
/// notice its end, which may take long, has ended.
bool is_at_work(pid_t process);

/// Whether the name is that of a staging folder.
bool is_staging_name(const std::filesystem::path& name);

/// Removes a staging folder whose changes are complete or undone, as far as possible. The
/// journal of a FolderChange goes after the old files, which nobody could put back without it.
void remove_staging(const std::filesystem::path& staging);

/// What is known of a staging folder whose process may be gone.
struct Abandoned {
    bool is_known = true;  ///< whether it could be found out
    int lock = -1;  ///< descriptor to close; -1 if its process lives, or it is no folder
};

/// Locks a staging folder if its process is gone. \pre is_staging_name(path)
Abandoned lock_of_abandoned(const std::filesystem::path& path);

}  // namespace endmill
