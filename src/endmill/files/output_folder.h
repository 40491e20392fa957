// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// The treatment of an output folder that is not empty.
enum class FullFolder {
    Refuse,  ///< an error
    Accept,  ///< new files replace files of the same names; the others stay
};

/// An output folder whose files become visible all together when they are complete, or
/// not at all.
///
/// `write` stores a file beside its final place under a temporary name; `publish` renames
/// all of them. An `OutputFolder` that is destroyed before `publish` removes its
/// temporary files and the folders that it created. All output of the library goes
/// through this class.
class OutputFolder {
public:
    /// Creates the folder and missing parent folders.
    /// \throws DomainError if `path` is a file, or a folder that is not empty if
    ///         `full` refuses it.
    /// \throws OutputError if the folder cannot be created, read or written to.
    explicit OutputFolder(std::filesystem::path path,
                          FullFolder full = FullFolder::Refuse);

    /// Unless published, removes the temporary files and the folders that it created.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;             ///< it owns temporary files
    OutputFolder& operator=(const OutputFolder&) = delete;  ///< it owns temporary files

    const std::filesystem::path& path() const { return path_; }  ///< as given

    /// Protects an input file: `write` refuses to replace it and `publish` never removes
    /// it.
    void protect(const std::filesystem::path& input);

    /// Makes `publish` remove a file of an earlier run of the same command, unless this
    /// run writes it. Only a regular file is removed, and only if no folder between it
    /// and `path()` is a symbolic link. Its folder is then removed too if it is empty.
    /// \throws DomainError for a name that `write` would refuse.
    void remove_unless_written(const std::filesystem::path& name);

    /// Writes a file and flushes it to the disk; `publish` makes it visible. A later file
    /// of the same name replaces it.
    /// \param name relative path without "..", such as "summary.json" or
    ///         "u/toolpath.csv".
    /// \throws DomainError for another name, or if it names a protected file.
    /// \throws OutputError if the file cannot be written (no space, a folder of that
    ///         name).
    void write(const std::filesystem::path& name, std::string_view content);

    /// Receives the next piece of a file.
    using Sink = std::function<void(std::string_view piece)>;

    /// Writes a file that need not fit into memory as a whole. `produce` passes the
    /// pieces in order to the sink that it receives. If it throws, no file is written.
    /// \throws as `write`, and whatever `produce` throws.
    void write_pieces(const std::filesystem::path& name,
                      const std::function<void(const Sink&)>& produce);

    /// Renames every file to its final name, in the order of writing, then removes the
    /// files named by `remove_unless_written`.
    /// \throws OutputError if a file cannot be renamed or removed, or after
    ///         `abandon_all`.
    void publish();

    /// Removes the temporary files and created folders of every unpublished
    /// `OutputFolder` of this process, for a program that is being interrupted.
    /// Afterwards every `OutputFolder` throws OutputError. Any thread may call it, a
    /// signal handler may not.
    static void abandon_all();

private:
    struct PendingFile {
        std::filesystem::path temporary;
        std::filesystem::path target;
    };

    void make_folders(const std::filesystem::path& folder);
    void forget(const std::filesystem::path& temporary);
    void check_target(const std::filesystem::path& target) const;
    bool is_input(const std::filesystem::path& target) const;
    void remove_leftover(const std::filesystem::path& name) const;
    void abandon();

    std::filesystem::path path_;
    std::vector<std::filesystem::path> inputs_;           // protected files
    std::vector<std::filesystem::path> created_folders_;  // outermost first
    std::vector<PendingFile> pending_;                    // written, not yet renamed
    std::vector<std::filesystem::path> leftovers_;        // to be removed unless written
};

/// Writes one file, complete or not at all, and replaces an existing one. Creates the
/// folder of the file if it is missing.
/// \throws OutputError if the file or its folder cannot be written.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace endmill
