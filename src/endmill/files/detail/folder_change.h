// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "endmill/files/detail/staging_folder.h"

namespace endmill {

/// The changes of a folder that one run publishes: new files, and old files to remove. They
/// are made one by one, and can be undone as long as not all are made, also by a later run:
///
///     STAGING/new/NAME   a new file that is not published yet
///     STAGING/old/NAME   an old file, moved out of the way
///     STAGING/names      the journal: what is done to each file and folder
///
/// Nothing is changed before the journal is on the disk and STAGING/old exists. Undoing only
/// renames files, each between two places, and removes empty folders. So it can be stopped at
/// any time and repeated.
///
/// No file named summary.json is in the folder while it is being changed: old ones go first,
/// new ones come last.
class FolderChange {
public:
    /// \param folder the folder. \param staging a StagingFolder in it.
    FolderChange(std::filesystem::path folder, std::filesystem::path staging);

    /// Makes all changes, or none of them. If it fails and the system does not even let it
    /// restore the folder, `staging` is released, and a later run restores it.
    /// \param written names of files in STAGING/new. \param removed names of old files.
    /// \throws OutputError with the name of the file and the reason.
    void make(const std::vector<std::filesystem::path>& written,
              const std::vector<std::filesystem::path>& removed, StagingFolder& staging);

    /// Undoes the changes, unless all new files are published.
    /// \return false if something cannot be undone, or if the journal cannot be read.
    bool undo();

private:
    enum class Fate : char;
    struct Entry;
    using Journal = std::vector<Entry>;

    static std::optional<Journal> journal_in(const std::filesystem::path& file);
    static void write(const Journal& journal, const std::filesystem::path& file);
    Journal journal_of(const std::vector<std::filesystem::path>& written,
                       const std::vector<std::filesystem::path>& removed) const;
    bool is_complete(const Journal& journal) const;
    bool undo(const Entry& entry);
    void move_away(const std::filesystem::path& name);
    void publish(const std::filesystem::path& name);

    std::filesystem::path folder_;
    std::filesystem::path staging_;
};

/// Undoes the unfinished changes of runs that were killed in `folder`, and removes their
/// staging folders. Those of runs that still go on stay.
/// \return a staging folder whose changes cannot be undone; empty if there is none.
std::filesystem::path clear_abandoned_runs(const std::filesystem::path& folder);

}  // namespace endmill
