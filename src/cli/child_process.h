// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// A new folder that only this user may enter. It is removed with its content when this
/// object is destroyed, and also when the program is interrupted.
class PrivateFolder {
public:
    /// \param parent an existing folder; the new folder gets a random name in it.
    /// \throws OutputError if the folder cannot be created.
    explicit PrivateFolder(const std::filesystem::path& parent);
    ~PrivateFolder();                                         ///< removes the folder
    PrivateFolder(const PrivateFolder&) = delete;             ///< one folder, one owner
    PrivateFolder& operator=(const PrivateFolder&) = delete;  ///< not assignable either

    const std::filesystem::path& path() const { return path_; }  ///< absolute

    /// Writes a file. \throws OutputError
    void write(const std::string& name, std::string_view content) const;

private:
    std::filesystem::path path_;
};

/// A program to run, and its limits.
struct ChildTask {
    std::filesystem::path program;       ///< absolute path
    std::vector<std::string> arguments;  ///< without the name of the program
    std::filesystem::path
        folder;                ///< working folder; both outputs go to its file log.txt
    double most_seconds = 60;  ///< wall time and processor time
    double most_memory_bytes = 2e9;  ///< address space
    double most_file_bytes = 1e9;    ///< size of each file that it writes
};

/// The end of a child process.
enum class ChildEnd {
    NotStarted,   ///< the program could not be loaded
    Exited,       ///< by itself, with an exit code
    Signalled,    ///< by a signal, such as a fault of its own
    OutOfTime,    ///< ended by the limit of the time
    FileTooLong,  ///< ended by the limit of the size of a file
};

/// How a child process ended.
struct ChildResult {
    ChildEnd end;
    int code;  ///< number of the signal if one ended it, else the exit code
};

/// Runs a program without a shell, with an empty standard input and a minimal
/// environment, and waits for its end. It runs in a process group of its own. The group is
/// ended at the limit of time and when this program is interrupted. If this program is
/// killed, only the child itself is ended, and the private folder remains. A limit that
/// exceeds the hard limit of this process is lowered to it.
/// \throws OutputError if the process cannot be started.
ChildResult run_child(const ChildTask& task);

/// Ends the running child process and removes the private folders, for a program that is
/// being interrupted.
void abandon_children();

/// The absolute path of a program on the PATH; empty if there is none.
std::filesystem::path program_on_path(const std::string& name);

}  // namespace endmill
