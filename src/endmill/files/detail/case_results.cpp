// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/case_results.h"

#include "endmill/core/error.h"
#include "endmill/files/output_folder.h"

namespace endmill {

int write_missing_results(std::span<const std::string> files, const CaseShard& shard,
                          const std::filesystem::path& folder,
                          const std::function<std::string(std::size_t)>& result)
{
    require(1 <= shard.number && shard.number <= shard.count,
            "write_missing_results: need 1 <= number <= count");
    int run = 0;
    const auto step = static_cast<std::size_t>(shard.count);
    for (auto i = static_cast<std::size_t>(shard.number) - 1; i < files.size();
         i += step) {
        if (std::filesystem::exists(folder / files[i]))
            continue;
        const std::string text = result(i);
        OutputFolder output{folder, FullFolder::Accept};
        output.write(files[i], text);
        output.publish();
        ++run;
    }
    return run;
}

}  // namespace endmill
