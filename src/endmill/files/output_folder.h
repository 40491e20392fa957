// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
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
/// `write` stores a file in a hidden staging folder; `publish` moves all of them to their
/// places. A folder that does not exist yet appears as a whole, by one rename. In one that
/// exists the summary of an earlier run is taken away first, and the new one comes last; if
/// a step fails, the folder becomes what it was before. If the process is killed meanwhile,
/// the next OutputFolder of the same folder restores it. It also removes the staging folders
/// of processes that are gone.
///
/// An `OutputFolder` that is destroyed before `publish` removes its staging folder and the
/// folders that it created. All output of the library goes through this class.
class OutputFolder {
public:
    /// Creates missing parent folders and the staging folder.
    /// \throws DomainError if `path` is a file, or a folder that is not empty if
    ///         `full` refuses it. Files that a killed process left do not count.
    /// \throws OutputError if the folder cannot be created, read or written to, such as a
    ///         link to a place that does not exist or a name that is too long.
    explicit OutputFolder(std::filesystem::path path,
                          FullFolder full = FullFolder::Refuse);

    /// Unless published, removes the staging folder and the folders that it created.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;             ///< it owns a staging folder
    OutputFolder& operator=(const OutputFolder&) = delete;  ///< it owns a staging folder

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

    /// Moves every file to its final place, and removes the files named by
    /// `remove_unless_written`: all of it, or nothing.
    /// \throws OutputError if a file cannot be moved or removed, or after `abandon_all`.
    void publish();

    /// Removes the staging and created folders of every unpublished `OutputFolder` of this
    /// process, for a program that is being interrupted. Afterwards every `OutputFolder`
    /// throws OutputError. Any thread may call it, a signal handler may not.
    static void abandon_all();

    /// Does the same, or nothing if a thread is just changing an output folder.
    static void abandon_all_unless_busy();

private:
    struct Staging;

    void make_parents();
    void make_staging();
    std::filesystem::path place_of_files() const;
    void check_target(const std::filesystem::path& target) const;
    bool is_input(const std::filesystem::path& target) const;
    std::vector<std::filesystem::path> leftovers() const;
    static void abandon_each();
    void abandon();

    std::filesystem::path path_;
    std::vector<std::filesystem::path> inputs_;           // protected files
    std::vector<std::filesystem::path> created_folders_;  // outermost first
    std::vector<std::filesystem::path> written_;          // names, in order, each once
    std::vector<std::filesystem::path> to_be_removed_;    // names, unless written
    std::unique_ptr<Staging> staging_;
};

/// Writes one file, complete or not at all, and replaces an existing one. Creates the
/// folder of the file if it is missing.
/// \throws OutputError if the file or its folder cannot be written.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace endmill
