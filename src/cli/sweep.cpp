// SPDX-License-Identifier: GPL-3.0-or-later
// endmill sweep: runs a command or a job for many cases.

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/program_description.h"
#include "cli/program_ranks.h"
#include "cli/surface_facts.h"
#include "cli/sweep_progress.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/job/sweep.h"

namespace endmill {
namespace {

constexpr int most_jobs = 1024;
constexpr std::uint64_t most_shards = 1'000'000;

constexpr std::array kept_choices{Choice<KeptCases>{"none", KeptCases::None},
                                  Choice<KeptCases>{"failed", KeptCases::Failed},
                                  Choice<KeptCases>{"all", KeptCases::All}};

struct SweepCommandOptions {
    CommonOptions common;
    std::string plan;
    std::vector<std::string> merged;
    SweepShard shard;
    std::optional<int> jobs;
    bool resume = false;
    KeptCases kept = KeptCases::None;
    std::optional<double> most_seconds;
    std::optional<double> most_gib;
};

// Parses "I/N". \throws CLI::ValidationError
SweepShard shard_argument(const std::string& option, const std::string& text)
{
    SweepShard shard{0, 0};
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.number);
    const char* const slash = first.ptr;
    if (first.ec == std::errc{} && slash != end && *slash == '/') {
        const auto second = std::from_chars(slash + 1, end, shard.count);
        if (second.ec == std::errc{} && second.ptr == end && shard.number >= 1 &&
            shard.number <= shard.count && shard.count <= most_shards)
            return shard;
    }
    throw CLI::ValidationError(option, "found " + printable(text, 40) +
                                           "; expected I/N with I from 1 to N and N at "
                                           "most 1000000, such as 2/8");
}

int cores()
{
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

SweepOptions sweep_options(const SweepCommandOptions& options, const Ranks& ranks,
                           const ProgramDescription& program)
{
    const int jobs = options.jobs.value_or(1);
    if (jobs > 1 && ranks.count() > 1)
        throw DomainError{"--jobs: found " + std::to_string(jobs) +
                          ", and under MPI each rank runs one case at a time; expected "
                          "more ranks"};
    // Ranks share the cores of their machines in a way that is not known here.
    const int threads = options.common.threads.value_or(ranks.count() > 1 ? 1 : cores());
    return {.program = program.program,
            .folder = output_folder(options.plan, "sweep", options.common),
            .full_folder = options.common.full_folder,
            .resume = options.resume,
            .shard = options.shard,
            .jobs = jobs,
            .threads_of_case = std::max(1, threads / jobs),
            .kept = options.kept,
            .most_seconds = options.most_seconds,
            .most_gib = options.most_gib};
}

Json summary_of(const SweepTotals& totals, const std::string& name)
{
    return {{"name", name},
            {"cases", totals.cases},
            {"before", totals.before},
            {"failed", totals.failed},
            {"first_failure", totals.first_failure},
            {"empty_columns", totals.empty_columns},
            {"wall_s", totals.wall_s}};
}

std::string text_of(const SweepTotals& totals, const std::string& folder)
{
    std::string text =
        counted(totals.cases, "case") + ", " + std::to_string(totals.failed) + " failed";
    if (totals.before > 0)
        text += fmt::format(", {} done before", totals.before);
    if (!totals.first_failure.empty())
        text += "\nfirst failure: " + totals.first_failure;
    return text + "\nwritten to " + printable(folder) + "\n";
}

void report(const SweepCommandOptions& options, const SweepTotals& totals,
            const std::string& name, const std::string& folder)
{
    for (const std::string& column : totals.empty_columns)
        warn(options.common,
             "column " + column +
                 " is empty in all cases; expected a key of summary.json");
    print_result(options.common, summary_of(totals, name), text_of(totals, folder));
}

ExitCode merge(const SweepCommandOptions& options)
{
    if (options.common.output.empty())
        throw DomainError{"--merge: found no folder for the results; expected --output"};
    const std::vector<std::filesystem::path> shards{options.merged.begin(),
                                                    options.merged.end()};
    const SweepTotals totals =
        merge_sweeps(shards, options.common.output, options.common.full_folder);
    report(options, totals, "", options.common.output);
    return ExitCode::Yes;
}

ExitCode sweep(const SweepCommandOptions& options, const ProgramDescription& program,
               Ranks& ranks)
{
    SweepWorkers workers{ranks};
    if (options.plan.empty() == options.merged.empty())
        throw DomainError{
            "found neither a plan nor --merge, or both; expected one of them"};
    if (!options.merged.empty())
        return merge(options);
    const SweepPlan plan = read_sweep_plan(options.plan, program, options.common.limits);
    SweepOptions running = sweep_options(options, ranks, program);
    SweepTotals totals;
    {
        const auto progress = sweep_progress("sweep", options.common);
        running.progress = [&](const SweepProgress& state) { progress->show(state); };
        totals = run_sweep(plan, running, workers);
    }
    report(options, totals, plan.name(), running.folder.string());
    return ExitCode::Yes;
}

void add_sweep_options(CLI::App& command, SweepCommandOptions& options)
{
    command.add_option("PLAN", options.plan, "plan of the sweep (endmill-sweep/1)");
    command
        .add_option("--merge", options.merged,
                    "join the results of all shards in place of a sweep")
        ->type_name("DIR...");
    command
        .add_option_function<std::string>(
            "--shard",
            [&options](const std::string& text) {
                options.shard = shard_argument("--shard", text);
            },
            "run every N-th case from the I-th on (default: all cases)")
        ->type_name("I/N");
    add_whole_number(
        command, {"--jobs", "number of cases at the same time (default 1)", 1, most_jobs},
        [&options](int count) { options.jobs = count; });
    command.add_flag("--resume", options.resume,
                     "go on with the sweep in the folder, if there is one");
    add_choice<KeptCases>(command, "--keep", options.kept, kept_choices,
                          "folders of cases that stay in DIR/cases (default none)");
    add_number(command,
               {"--limit-seconds", "S", "end a case after this time (default: none)"},
               options.most_seconds);
    add_number(command,
               {"--limit-gib", "GIB",
                "--max-memory of a case; a process gets at most 1.25 GIB + 0.5 GiB"},
               options.most_gib);
    add_common_options(command, options.common);
}

}  // namespace

void add_sweep_command(CLI::App& program, Action& action)
{
    CLI::App* command =
        program.add_subcommand("sweep", "run a command or a job for many cases");
    const auto options = std::make_shared<SweepCommandOptions>();
    add_sweep_options(*command, *options);
    command->footer(
        "The plan names a command or a job, and the values of its parameters: a grid, a\n"
        "list (CSV) or random samples. Writes results.csv with a row for each case, in\n"
        "the order of the plan, and sweep.json to --output (default ./NAME-sweep). A "
        "case\n"
        "is a process of its own; one that fails is a row. --threads are divided among\n"
        "the jobs. With --resume, a sweep that was interrupted goes on.\n\n"
        "Exit code 0 if all cases ran, also if some failed. docs/guide/sweeps.md has\n"
        "examples, also for batch systems and MPI.\n\n"
        "Example:\n"
        "  endmill sweep datasets/sweeps/scallops.json --jobs 2 -o scallops");
    command->callback([options, &program, &action] {
        action = [options, &program] {
            Ranks& ranks = program_ranks();
            if (ranks.rank() == 0)
                return sweep(*options, description_of(program), ranks);
            serve_sweep(ranks);
            return ExitCode::Yes;
        };
    });
}

}  // namespace endmill
