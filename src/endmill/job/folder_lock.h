// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace endmill {

/// The lock of a folder in which only one process may work at a time. The child processes
/// that it starts hold the lock too, and the system releases it when the last of them ends in
/// any way: a lock never outlives its owners, and nobody meets the children of a process that
/// was killed at work.
class FolderLock {
public:
    /// Takes the lock. It waits up to 10 s for the children of a process that is gone.
    /// \param folder an existing folder. The lock is the file .endmill-lock in it, which holds
    ///        the number of the process and the name of its machine.
    /// \param what   the work of the folder, for the message, such as "a run".
    /// \throws OutputError if another process has it, with the number of that process; or if
    ///         the file cannot be written.
    FolderLock(const std::filesystem::path& folder, const std::string& what);
    ~FolderLock();                           ///< releases it and removes the file
    FolderLock(const FolderLock&) = delete;  ///< one lock, one owner
    FolderLock& operator=(const FolderLock&) = delete;  ///< not assignable either

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace endmill
