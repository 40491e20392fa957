// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/memory_limit.h"
#include "cli/view.h"
#include "endmill/core/parallel.h"

namespace endmill {

void add_common_options(CLI::App& command, CommonOptions& options)
{
    const std::string group = "Options of every command";
    command
        .add_option("-o,--output", options.output,
                    "folder for the results (default: see below)")
        ->type_name("DIR")
        ->group(group);
    command
        .add_flag("--json", options.json,
                  "print the summary as one JSON object, with all digits")
        ->group(group);
    command.add_flag("--quiet", options.quiet, "print errors only")->group(group);
    command
        .add_flag_callback(
            "--force", [&options] { options.full_folder = FullFolder::Accept; },
            "write into a folder that is not empty")
        ->group(group);
    add_whole_number(command,
                     {"--threads", "number of threads (default: all cores)", 1, 1024},
                     [&options](int count) {
                         options.threads = count;
                         set_thread_count(count);
                     })
        ->group(group);
    add_number(command, {"--max-memory", "GIB", "largest memory to use"},
               options.limits.max_memory_gib)
        ->group(group);
    add_number(command,
               {"--max-extent", "MM", "largest coordinate of a file, and largest cutter"},
               options.limits.max_extent_mm)
        ->group(group);
    command
        .add_flag("--json-progress", options.json_progress,
                  "print progress on standard error as JSON, one object a line")
        ->group(group);
    command.add_flag("--json-errors", options.json_errors, "print errors as JSON")
        ->group(group);
    command.parse_complete_callback([&command, &options] {
        for (const CLI::Option* option : command.get_options())
            if (option->count() > 0)
                options.given.insert(option->get_name());
        limit_memory(options.limits.max_memory_gib, options.threads, command.get_name());
    });
}

void add_html_option(CLI::App& command, CommonOptions& options)
{
    // A build without the page is refused before the work begins.
    command
        .add_flag("--html", options.html,
                  "also write page.html, which shows the results in a browser, as "
                  "endmill view does")
        ->each([](const std::string&) { require_page(); });
}

}  // namespace endmill
