// SPDX-License-Identifier: GPL-3.0-or-later
// endmill demo: runs a job that is delivered with the program.

#include <memory>

#include "cli/console.h"
#include "cli/data_folder.h"
#include "cli/program_description.h"
#include "cli/run_options.h"
#include "endmill/core/text.h"
#include "endmill/job/job_run.h"

namespace endmill {
namespace {

constexpr const char* demo_job = "economic-cl-data.json";
constexpr const char* default_folder = "endmill-demo";

// The path that `verify` judged, from its summary.
std::filesystem::path verified_path(const std::filesystem::path& folder)
{
    const Json summary = Json::parse(read_file(folder / "summary.json"));
    return summary.at("toolpath").get<std::string>();
}

ExitCode run_demo(const CommonOptions& common, const ProgramDescription& program)
{
    RunOptions options;
    options.common = common;
    if (common.output.empty())
        options.common.output = default_folder;
    options.file = (data_folder("demo", "jobs") / demo_job).string();
    const ExitCode exit = run_job_command(options, program);
    if (exit != ExitCode::Yes || common.json || common.quiet)
        return exit;
    const std::filesystem::path folder = options.common.output;
    const std::filesystem::path picture =
        verified_path(folder / "05-verify").parent_path() / "toolpath.svg";
    print("picture of the path: " + printable(picture.string()) +
          "\npicture of the remaining stock: " +
          printable((folder / "05-verify/deviation.svg").string()) +
          "\nG-code: " + printable((folder / "07-post/toolpath.ngc").string()) + "\n");
    return exit;
}

}  // namespace

void add_demo_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "demo", "run an example: from a surface to a verified program, with pictures");
    const auto options = std::make_shared<CommonOptions>();
    add_common_options(*command, *options);
    command->footer(
        "Runs datasets/jobs/economic-cl-data.json, a job that is delivered with "
        "endmill:\n"
        "plan, verify, post. It writes to --output (default ./endmill-demo) and ends "
        "with\n"
        "the names of the pictures and of the G-code. Takes some seconds.\n\n"
        "Example:\n"
        "  endmill demo");
    command->callback([options, &action, &program] {
        action = [options, &program] {
            return run_demo(*options, description_of(program));
        };
    });
}

}  // namespace endmill
