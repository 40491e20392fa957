// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/command.h"
#include "endmill/core/parallel.h"

namespace endmill {

void add_common_options(CLI::App& command, CommonOptions& options)
{
    const std::string group = "Options of every command";
    command.add_option("-o,--output", options.output, "folder for the results")
        ->type_name("DIR")
        ->group(group);
    command
        .add_flag("--json", options.json,
                  "print the summary as one JSON object, and nothing else")
        ->group(group);
    command.add_flag("--quiet", options.quiet, "print errors only")->group(group);
    command.add_flag("--force", options.force, "write into a folder that is not empty")
        ->group(group);
    add_whole_number(command, "--threads", {1, 1024},
                     "how many threads to use; default all",
                     [](int count) { set_thread_count(count); })
        ->group(group);
    add_number(command, "--max-memory", options.limits.max_memory_gib,
               NumberDomain::positive(), "GIB", "most memory to use")
        ->group(group);
    add_number(command, "--max-extent", options.limits.max_extent_mm,
               NumberDomain::positive(), "MM", "largest coordinate to believe in a file")
        ->group(group);
    command.add_flag("--json-errors", options.json_errors, "print errors as JSON")
        ->group(group);
}

}  // namespace endmill
