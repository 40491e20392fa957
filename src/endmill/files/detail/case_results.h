// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace endmill {

/// Part of a list of cases: every `count`-th from `number` (1 to count) on.
struct CaseShard {
    int number = 1;
    int count = 1;
};

/// Writes the results of independent cases, one file each, that are not yet in a folder. Each file
/// appears as a whole when its case ends. So an interrupted run goes on where it ended, and several
/// processes may write the shards of one list into one folder; the files do not depend on either.
/// \param files  names of the results, all different.
/// \param shard  the cases to run.
/// \param folder of the results; missing folders are created.
/// \param result text of the result of a case, by its position in `files`; what it throws ends the run.
/// \return number of cases run.
/// \throws DomainError unless 1 <= number <= count.
/// \throws OutputError if a file cannot be written.
int write_missing_results(std::span<const std::string> files, const CaseShard& shard,
                          const std::filesystem::path& folder,
                          const std::function<std::string(std::size_t)>& result);

}  // namespace endmill
