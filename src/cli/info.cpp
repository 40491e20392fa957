// SPDX-License-Identifier: GPL-3.0-or-later
// endmill info: measures of a part and the largest ball that fits it, or of a tool path.

#include <array>
#include <memory>
#include <span>

#include "cli/console.h"
#include "cli/idle_options.h"
#include "cli/info_path.h"
#include "cli/info_summary.h"
#include "cli/mesh_remarks.h"
#include "cli/progress.h"
#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/files/output_folder.h"
#include "endmill/surface/continuity.h"

namespace endmill {
namespace {

// The options that apply to tool paths only.
constexpr std::array path_option_names{
    "--cutter",      "--programmed-point",    "--arc-tolerance", "--block-delete",
    "--interpreter", "--interpreter-seconds", "--tools",         "--tools-units"};

struct InfoOptions {
    CommonOptions common;
    PartOptions part;
    PathOptions path;  ///< the same file, if it holds a tool path
    Vec3 axis = Vec3::UnitZ();
    RequiredContinuity required = RequiredContinuity::None;
};

void write_summary(const InfoOptions& options, const Json& summary)
{
    if (options.common.output.empty())
        return;
    OutputFolder folder{options.common.output, options.common.full_folder};
    folder.protect(options.part.path);
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.publish();
}

ExitCode run_info(const InfoOptions& options)
{
    if (is_tool_path(options.part.path, options.common.limits)) {
        refuse_idle_options(options.common,
                            std::array{"--units", "--up", "--axis", "--require"},
                            "a tool path", "a part");
        PathOptions path = options.path;
        path.file = options.part.path;
        return report_path(path, options.common);
    }
    refuse_idle_options(options.common, path_option_names, "a part", "a tool path");
    PartOptions part = options.part;
    part.keeps_import = !options.common.output.empty();
    const PartFile file = read_part_for(part, options.common);
    const auto* surfaces = std::get_if<std::vector<Surface>>(&file.part);
    if (!surfaces) {
        refuse_idle_options(options.common, std::array{"--require", "--axis"}, "a mesh",
                            "a surface");
        const Json summary = [&] {
            const ProgressLine progress{"checking the mesh", options.common};
            return mesh_summary(file, options.part);
        }();
        if (summary["non_manifold_edges"] != 0)
            warn(options.common,
                 options.part.path + ": " +
                     non_manifold_text(summary["non_manifold_edges"],
                                       summary["first_non_manifold_edge"].dump()));
        write_summary(options, summary);
        print_result(options.common, summary, mesh_text(summary));
        return ExitCode::Yes;
    }
    const SurfaceContinuity whole = continuity(std::span{*surfaces});
    const Json summary = [&] {
        const ProgressLine progress{"measuring the surface", options.common};
        return surface_summary(file, whole, options.axis);
    }();
    write_summary(options, summary);
    print_result(options.common, summary, surface_text(summary));
    if (whole.continuity != Continuity::G1 && options.required == RequiredContinuity::G1)
        return refuse_break(options.part.path, whole, options.common);
    return ExitCode::Yes;
}

}  // namespace

void add_info_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "info", "report on a part (size, curvature, largest ball) or a tool path");
    const auto options = std::make_shared<InfoOptions>();
    command
        ->add_option("FILE", options->part.path,
                     "surface file (endmill-surface/1), mesh (.stl, .obj, .ply, .off), "
                     "CAD file (.step, "
                     ".stp, .iges, .igs), "
                     "or tool path (CSV, G-code, APT CL data, output of rs274 -g)")
        ->required();
    add_mesh_options(*command, options->part);
    add_axis_option(*command, options->axis);
    add_require_option(*command, options->required);
    add_cutter_option(*command, options->path);
    add_tools_options(*command, options->path);
    add_reading_options(*command, options->path);
    add_common_options(*command, options->common);
    command->footer(
        "Prints the result. With --output it also writes DIR/summary.json. For a tool "
        "path it\n"
        "reports length of cuts, links and rapids, time at feed, extent, feeds and "
        "tools.\n\n"
        "Example:\n  endmill info datasets/surfaces/net_rot24_7D.json");
    command->callback(
        [options, &action] { action = [options] { return run_info(*options); }; });
}

}  // namespace endmill
