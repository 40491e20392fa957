// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// A folder whose files appear whole and together, or not at all: each is written beside
/// its place under a temporary name, and `publish` renames them all. One that is never
/// published leaves nothing behind. Nothing else in the project opens a file for writing.
class OutputFolder {
public:
    /// Creates the folder, and those above it, if missing.
    /// \param force write also into a folder that is not empty.
    /// \throws DomainError if `path` is a file, or not empty without `force`.
    /// \throws OutputError if the folder cannot be created, read or written to.
    explicit OutputFolder(std::filesystem::path path, bool force = false);

    /// Unless published, removes the temporary files and the folders that it created.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;             ///< one folder, one owner
    OutputFolder& operator=(const OutputFolder&) = delete;  ///< ditto

    const std::filesystem::path& path() const { return path_; }  ///< as given

    /// Makes `write` refuse to replace `input`, and keeps it from being removed.
    void protect(const std::filesystem::path& input);

    /// Makes `publish` remove a file that an earlier run of the same command may have
    /// left, unless this one writes it. Only a plain file, reached through no symbolic
    /// link below `path()`, is removed; then its folder, if that is left empty.
    /// \throws DomainError as `write`, for a name that it would refuse.
    void remove_unless_written(const std::filesystem::path& name);

    /// Writes a file, flushed to the disk, that `publish` will show; a later one of the
    /// same name replaces it.
    /// \param name relative, without "..", such as "summary.json" or "u/toolpath.csv".
    /// \throws DomainError for another name, or if it is a protected file.
    /// \throws OutputError if it cannot be written: no space, a folder in its place.
    void write(const std::filesystem::path& name, std::string_view content);

    /// Takes the next piece of a file.
    using Sink = std::function<void(std::string_view piece)>;

    /// The same for a file that need never be in memory as a whole: `produce` hands its
    /// pieces, in order, to the sink that it is given. If it throws, there is no file.
    void write_pieces(const std::filesystem::path& name,
                      const std::function<void(const Sink&)>& produce);

    /// Renames every file to its own name, in the order written, then removes what is
    /// left of an earlier run.
    /// \throws OutputError if that fails, or after `abandon_all`.
    void publish();

    /// For a program that is being interrupted: removes the temporary files and created
    /// folders of all that is unpublished. From then on every `OutputFolder` of this
    /// process throws OutputError. May be called by any thread, not by a signal handler.
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
    std::vector<std::filesystem::path> inputs_;
    std::vector<std::filesystem::path> created_folders_;  // outermost first
    std::vector<PendingFile> pending_;
    std::vector<std::filesystem::path> leftovers_;  // names, unless they are written
};

/// Writes one file, whole or not at all, replacing what was there; creates its folder.
/// \throws OutputError if that fails.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace endmill
