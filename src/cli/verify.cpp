// SPDX-License-Identifier: GPL-3.0-or-later
// endmill verify: what a tool path really leaves.

#include <memory>

#include "cli/console.h"
#include "cli/progress.h"
#include "cli/verify_files.h"
#include "cli/verify_input.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"

namespace endmill {
namespace {

ExitCode run_verify(const VerifyOptions& options)
{
    const VerifyInput input = read_verify_input(options);
    for (const std::string& remark : input.program.remarks)
        warn(options.common, options.path.file + ": " + remark);
    OutputFolder folder{output_folder(options.path.file, "verify", options.common),
                        options.common.force};
    for (const std::string& file : files_of(input, options))
        folder.protect(file);

    ProgressLine progress{"removing and measuring", options.common};
    VerificationTask task = verification_task(input, options);
    task.progress = [&](double share) { progress.show(share); };
    const Verification verification =
        naming(options.path.file, [&] { return verify_path(task); });
    const Json summary = write_verification({input, options, task, verification}, folder);
    folder.publish();
    print_result(options.common, summary,
                 verify_text(summary, verification) + "written to " +
                     printable(folder.path().string()) + "\n");
    return verification.verdict == Verdict::Clean ? ExitCode::Yes : ExitCode::No;
}

}  // namespace

void add_verify_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "verify", "what a tool path leaves, and whether it gouges");
    const auto options = std::make_shared<VerifyOptions>();
    add_verify_options(*command, *options);
    command->footer(
        "Exit 0 if the path is clean, 1 if it gouges, leaves too much or stays "
        "undecided.\n"
        "Writes summary.json, removal.csv and, with a part, deviation.vtp, "
        "deviation.svg\n"
        "and histogram.csv to --output (default ./NAME-verify; NAME of "
        "results/u/toolpath.csv\n"
        "is results-u). Part, cutter and limits are those of the summary.json beside "
        "TOOLPATH, unless an option says "
        "otherwise.\n"
        "Points are numbered from 0 through the whole path, as in removal.csv.\n\n"
        "Example:\n  endmill plan datasets/surfaces/saddle.json --mode verified -o "
        "results\n"
        "  endmill verify results/u/toolpath.csv --resolution 0.5");
    command->callback(
        [options, &action] { action = [options] { return run_verify(*options); }; });
}

}  // namespace endmill
