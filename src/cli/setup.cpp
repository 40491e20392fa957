// SPDX-License-Identifier: GPL-3.0-or-later
// endmill setup: the setup of a part that needs the least rotary ranges.

#include <algorithm>
#include <memory>

#include "cli/console.h"
#include "cli/program_ranks.h"
#include "cli/progress.h"
#include "cli/setup_files.h"
#include "cli/setup_idle.h"
#include "cli/setup_nearest_cells.h"
#include "cli/setup_points.h"
#include "cli/setup_summary.h"
#include "cli/setup_toolpath.h"
#include "cli/setup_visibility.h"
#include "cli/view.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

void check_setup_options(const SetupCommandOptions& options)
{
    const int subjects = (options.part.path.empty() ? 0 : 1) +
                         (options.points.empty() ? 0 : 1) +
                         (options.toolpath.empty() ? 0 : 1);
    if (subjects != 1)
        throw DomainError{"expected either PART, --points or --path"};
    if (options.clamp &&
        options.clamp->lpNorm<Eigen::Infinity>() > options.common.limits.max_extent_mm)
        throw DomainError{"--clamp: found a coordinate beyond --max-extent"};
    refuse_idle_setup_options(options);
}

std::vector<SetupAnswer> ranked_answers(const SetupInput& input,
                                        const SetupVisibility& visibility,
                                        const SetupCommandOptions& options)
{
    std::vector<SetupAnswer> answers;
    for (const SearchedMachine& machine : input.machines)
        answers.push_back(answer_for(machine, input, visibility, options));
    // The files of a folder are sorted by name, and setups of equal rank stay so.
    std::ranges::stable_sort(answers, {}, [&](const SetupAnswer& answer) {
        return setup_rank(answer.setup, options.floor_deg);
    });
    return answers;
}

ExitCode run_setup(const SetupCommandOptions& options)
{
    check_setup_options(options);
    if (program_ranks().rank() > 0) {
        send_visibility(options);
        serve_nearest_cells();
    }
    if (!options.points.empty())
        return run_setup_points(options);
    if (!options.toolpath.empty())
        return run_setup_toolpath(options);
    const SetupInput input = read_setup_input(options);
    for (const std::string& remark : input.remarks)
        warn(options.common, options.part.path + ": " + remark);
    OutputFolder folder{output_folder(options.part.path, "setup", options.common),
                        options.common.full_folder};
    for (const std::string& file : {options.part.path, options.tool, options.skip_facets})
        if (!file.empty())
            folder.protect(file);
    for (const SearchedMachine& machine : input.machines)
        if (!machine.file.empty())
            folder.protect(machine.file);
    const SetupVisibility visibility = visibility_for(input, options);
    std::vector<SetupAnswer> answers = ranked_answers(input, visibility, options);
    answers.front().missed = missed_facets(answers.front(), input, visibility, options);
    Json summary = setup_summary(input, visibility, answers, options);
    name_part(summary, options.part, folder.path());
    {
        const ProgressLine progress{"writing the results", options.common};
        write_setup_files(input, visibility, answers.front(), options, folder);
    }
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.remove_unless_written("page.html");
    folder.publish();
    write_html(folder.path(), options.common);
    print_result(
        options.common, summary,
        setup_text(summary) + "written to " + printable(folder.path().string()) + "\n");
    return answers.front().setup.is_machinable() ? ExitCode::Yes : ExitCode::No;
}

}  // namespace

void add_setup_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "setup",
        "find the setup of a part that needs the least rotary ranges, or list the facets "
        "that no setup reaches");
    const auto options = std::make_shared<SetupCommandOptions>();
    add_setup_options(*command, *options);
    command->footer(
        "Writes visibility.bsm, cones.csv (a row for each facet), setup.vtp, setup.svg,\n"
        "sphere.svg and summary.json to --output (default ./NAME-setup). With --points "
        "the\n"
        "command only prints the result; with --output it also writes "
        "DIR/summary.json.\n"
        "With --path it writes summary.json only: a setup in which the machine runs the\n"
        "whole path. Exit 4 names the point of the path that is out of reach.\n\n"
        "phi and theta are rotations of the tool against the part. C,A: phi is the "
        "tilt,\n"
        "theta the rotation of C. A,B: phi is the rotation of the axis nearer to the "
        "part.\n\n"
        "Exit 1: the part is not machinable in one setup (the report states the ranges "
        "that\n"
        "it would need), the answer is undecided, or the setup exceeds the travel of "
        "the\n"
        "linear axes (with --within-travel: every pose that was tried exceeds it).\n\n"
        "mpirun -n N endmill setup PART ... divides the directions among N processes, "
        "and\n"
        "for large parts the facets of the search.\n\n"
        "Example:\n"
        "  endmill setup datasets/meshes/teapot-288.off --machine W/caxyBz/T -o teapot\n"
        "  endmill setup datasets/meshes/teapot-288.off --machine all --from-visibility "
        "teapot/visibility.bsm -o machines\n"
        "  endmill setup datasets/meshes/teapot-288.off --machine "
        "datasets/machines/ca-head-head.json --within-travel -o teapot-travel\n"
        "  endmill setup --path datasets/paths/dome.csv --machine "
        "datasets/machines/ca-table-table.json -o path-setup");
    command->callback([options, &action] {
        action = [options] {
            const std::string& file =
                options->toolpath.empty() ? options->part.path : options->toolpath;
            return naming(file, [&] { return run_setup(*options); });
        };
    });
}

}  // namespace endmill
