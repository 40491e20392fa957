// SPDX-License-Identifier: GPL-3.0-or-later
// endmill info: what a part is like, and which ball fits it.

#include <memory>
#include <span>

#include "cli/console.h"
#include "cli/info_summary.h"
#include "cli/surface_facts.h"
#include "endmill/io/output_folder.h"
#include "endmill/surface/patch_borders.h"

namespace endmill {
namespace {

struct InfoOptions {
    CommonOptions common;
    std::string part;
    Vec3 axis = Vec3::UnitZ();
    bool g1_is_required = false;
};

ExitCode run_info(const InfoOptions& options)
{
    const SurfaceFile file = read_part(options.part, options.common);
    const SurfaceContinuity whole = continuity(std::span<const Surface>{file.surfaces});
    const Json summary = info_summary(file, whole, options.axis);
    if (!options.common.output.empty()) {
        OutputFolder folder{options.common.output, options.common.force};
        folder.protect(options.part);
        folder.write("summary.json", summary.dump(2) + "\n");
        folder.publish();
    }
    print_result(options.common, summary, info_text(summary));
    if (whole.continuity == Continuity::G1)
        return ExitCode::Yes;
    if (options.g1_is_required)
        return refuse_break(options.part, whole, options.common);
    warn(options.common, options.part + ": " + break_text(whole));
    return ExitCode::Yes;
}

}  // namespace

void add_info_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "info", "size, area, continuity, curvature and largest ball cutter of a part");
    const auto options = std::make_shared<InfoOptions>();
    command->add_option("PART", options->part, "surface file (endmill-surface/1)")
        ->required();
    add_axis_option(*command, options->axis);
    add_require_option(*command, options->g1_is_required);
    add_common_options(*command, options->common);
    command->footer(
        "Prints; writes DIR/summary.json only with --output.\n\n"
        "Example:\n  endmill info datasets/surfaces/net_rot24_7D.json --json");
    command->callback(
        [options, &action] { action = [options] { return run_info(*options); }; });
}

}  // namespace endmill
