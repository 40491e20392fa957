// SPDX-License-Identifier: GPL-3.0-or-later
// endmill verify: simulates the cut and bounds gouge and remaining material.

#include <memory>
#include <optional>

#include "cli/console.h"
#include "cli/progress.h"
#include "cli/verify_files.h"
#include "cli/verify_input.h"
#include "cli/view.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"

namespace endmill {
namespace {

Verification verified(VerificationTask& task, const VerifyOptions& options)
{
    ProgressLine progress{"removing material", options.common};
    task.progress = [&](double share) {
        progress.begin("removing material");
        progress.show(share);
    };
    if (task.judged)
        task.judged->progress = [&](double share) {
            progress.begin("measuring the part");
            progress.show(share);
        };
    return verify_path(task);
}

// Measures gouges of the protected part, if there is one, and lets the verdict know.
std::optional<Deviation> protected_deviation(const VerifyInput& input,
                                             Verification& verification)
{
    if (!input.guard)
        return std::nullopt;
    Deviation found = input.guard->deviation(input.program.path);
    verification.verdict = input.guard->verdict(found, verification.verdict);
    return found;
}

// Without a part the answer is no, because nothing was compared, unless the command line
// asks for this.
ExitCode exit_code(Verdict verdict, const VerifyOptions& options)
{
    const bool is_yes = verdict == Verdict::Clean ||
                        (verdict == Verdict::NotJudged && options.part.path == no_part);
    return is_yes ? ExitCode::Yes : ExitCode::No;
}

ExitCode run_verify(const VerifyOptions& options)
{
    const VerifyInput input = read_verify_input(options);
    for (const std::string& remark : input.program.remarks)
        warn(options.common, options.path.file + ": " + remark);
    OutputFolder folder{output_folder(options.path.file, "verify", options.common),
                        options.common.full_folder};
    for (const std::string& file : files_of(input, options))
        folder.protect(file);

    VerificationTask task = verification_task(input, options);
    Verification verification =
        naming(options.path.file, [&] { return verified(task, options); });
    const std::optional<Deviation> of_protected =
        protected_deviation(input, verification);
    const Json summary = [&] {
        const ProgressLine progress{"writing the results", options.common};
        return write_verification({input, options, task, verification, of_protected},
                                  folder);
    }();
    folder.remove_unless_written("page.html");
    folder.publish();
    write_html(folder.path(), options.common);
    print_result(options.common, summary,
                 verify_text(summary, options, verification) + "written to " +
                     printable(folder.path().string()) + "\n");
    return exit_code(verification.verdict, options);
}

}  // namespace

void add_verify_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "verify", "simulate the cut and bound gouge and remaining stock");
    const auto options = std::make_shared<VerifyOptions>();
    add_verify_options(*command, *options);
    command->footer(
        "Exit 0: the verdict is clean. Exit 1: the path gouges the part or leaves too "
        "much\n"
        "stock, a rapid cuts, shank or holder touches stock or part, a protected part is "
        "gouged,\n"
        "or the error bound is too large to decide. Without a part the verdict is \"not "
        "judged\", exit 1; with "
        "--part\n"
        "none exit 0 unless a rapid cuts or shank or holder touches the stock.\n\n"
        "Writes summary.json, removal.csv and, with a part, deviation.vtp, "
        "deviation.svg\n"
        "and histogram.csv to --output (default ./NAME-verify; NAME of\n"
        "results/u/toolpath.csv is results-u). Part, cutter and limits default to those "
        "of\n"
        "the summary.json beside TOOLPATH. Points are numbered from 0 through the whole\n"
        "path, as in removal.csv.\n\n"
        "Example:\n"
        "  endmill plan datasets/surfaces/saddle.json --cutter ball:20 --strategy iso -o "
        "saddle\n"
        "  endmill verify saddle/u/toolpath.csv --resolution 0.5");
    command->callback(
        [options, &action] { action = [options] { return run_verify(*options); }; });
}

}  // namespace endmill
