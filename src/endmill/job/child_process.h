// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// Programs that run as child processes, with limits and without a shell.

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

/// Limits of a child process; an empty one is that of this process. A limit that exceeds the
/// hard limit of this process is lowered to it.
struct ChildLimits {
    std::optional<double> wall_seconds = {};         ///< time until its group is ended
    std::optional<double> processor_seconds = {};    ///< of all its threads together
    std::optional<double> address_space_bytes = {};  ///< of the process
    std::optional<double> data_bytes = {};           ///< that it allocates
    std::optional<double> file_bytes = {};  ///< size of each file in its working folder
    std::optional<int> open_files = {};     ///< at one time
};

/// A program to run.
struct ChildTask {
    std::filesystem::path program;       ///< absolute path
    std::vector<std::string> arguments;  ///< without the name of the program
    std::filesystem::path folder = ".";  ///< working folder
    /// File that is its standard input, open for reading only; if empty, there is no input.
    std::filesystem::path input = {};
    /// New file for both outputs. If it is empty, `output` receives the standard output and
    /// `error_line` the standard error.
    std::filesystem::path log = {};
    std::vector<std::string> environment = {};  ///< NAME=VALUE, all that the child sees
    ChildLimits limits = {};                    ///< of the child
    /// Receives the standard output in pieces, as it comes; if empty, it is discarded.
    std::function<void(std::string_view piece)> output = {};
    /// Receives each line of the standard error without its end, as it comes. A line is cut
    /// at 64 KiB.
    std::function<void(std::string_view line)> error_line = {};
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
    ChildEnd end;  ///< what ended it
    int code;      ///< number of the signal if one ended it, else the exit code
};

/// Runs a program without a shell, and waits for its end.
/// Several threads may do so at the same time. The child runs in a process group of its own,
/// which is ended at the limit of time and when this program is interrupted. If this program
/// is killed, only the child itself is ended, and private folders remain.
/// \throws OutputError if the process cannot be started, and whatever `output` and
///         `error_line` throw, after the child was ended.
ChildResult run_child(const ChildTask& task);

/// Interrupts the running child processes, ends those that do not end within a second, and
/// removes the private folders, for a program that is being interrupted itself.
void abandon_children();

/// The environment of a child that must not depend on this user's settings.
/// \param home folder that it sees as home.
std::vector<std::string> minimal_environment(const std::filesystem::path& home);

/// The environment of this process without the variables by which MPI recognises its
/// processes: a child is none of them.
std::vector<std::string> inherited_environment();

/// The absolute path of a program on the PATH; empty if there is none.
std::filesystem::path program_on_path(const std::string& name);

/// The absolute path of the running program. \throws OutputError if it is not known.
std::filesystem::path running_program();

}  // namespace endmill
