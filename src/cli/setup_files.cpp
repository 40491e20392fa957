// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_files.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "cli/setup_idle.h"
#include "endmill/figures/setup_figures.h"
#include "endmill/files/result_csv.h"
#include "endmill/files/visibility_file.h"
#include "endmill/visibility/visibility.h"

namespace endmill {
namespace {

ShownSetup shown_setup(const SetupAnswer& answer)
{
    const FittedPose& fit = *answer.reported();
    const Machine& machine = answer.machine->machine;
    ShownSetup setup{*answer.setup.part_to_machine,
                     pose_frame(machine.configuration, fit.pose),
                     {fit.phi, fit.theta},
                     {}};
    // Axes without any limits are not drawn.
    if (machine.rotary != RotaryLimits{})
        setup.limits = machine.rotary;
    return setup;
}

std::string range_text(const RotaryRange& range)
{
    return fmt::format("{:.2f} to {:.2f}", Angle::radians(range.from).degrees(),
                       Angle::radians(range.to).degrees());
}

std::vector<std::string> setup_captions(const SetupAnswer& answer,
                                        std::optional<SetupMode> mode)
{
    const FittedPose& fit = *answer.reported();
    const std::string prefix =
        mode ? "mode " + std::string{setup_mode_word(*mode)} + ": " : "";
    std::vector<std::string> captions{fmt::format("{}phi {}, theta {} degrees", prefix,
                                                  range_text(fit.phi),
                                                  range_text(fit.theta))};
    if (!answer.setup.best.feasible)
        captions.emplace_back(
            "no pose within the limits was found; this pose is the best one without "
            "limits");
    return captions;
}

std::string sphere_picture(const SetupInput& input, const SetupVisibility& visibility,
                           const SetupAnswer& answer, const SetupCommandOptions& options)
{
    const VisibilityMap& map = visibility.map();
    SphereFigure figure;
    figure.title = input.name + " on " + answer.machine->name + ": tool directions";
    figure.captions = setup_captions(answer, effective_mode(input.machines, options));
    figure.setup = shown_setup(answer);
    // Only these modes fit the pose to the nearest cells.
    if (options.mode != SetupMode::WholeCones &&
        answer.machine->machine.configuration.family)
        for (const std::size_t cell :
             nearest_cells(map, input.grid.centres, answer.reported()->cell))
            figure.marked.push_back(input.grid.centres[cell]);
    return sphere_svg(input.grid, map, figure);
}

void write_pictures(const SetupInput& input, const SetupVisibility& visibility,
                    const SetupAnswer& answer, const SetupCommandOptions& options,
                    OutputFolder& folder)
{
    const VisibilityMap& map = visibility.map();
    const FacetAccess access{
        visible_fractions(map, input.grid.solid_angles_sr),
        reached_at_zero(input.grid, map, answer.reported()->pose.tool_axis)};
    const ShownSetup setup = shown_setup(answer);
    folder.write("setup.vtp", setup_vtp(input.mesh, access, setup));
    folder.write("setup.svg",
                 setup_svg(input.mesh, access.reached_at_zero, setup,
                           {.title = input.name + " on " + answer.machine->name,
                            .captions = setup_captions(
                                answer, effective_mode(input.machines, options))}));
    folder.write("sphere.svg", sphere_picture(input, visibility, answer, options));
}

}  // namespace

void write_setup_files(const SetupInput& input, const SetupVisibility& visibility,
                       const SetupAnswer& answer, const SetupCommandOptions& options,
                       OutputFolder& folder)
{
    // Do not overwrite the file that was read: its contents would be the same.
    std::error_code ignored;
    const bool is_there =
        !options.from_visibility.empty() &&
        std::filesystem::equivalent(options.from_visibility,
                                    folder.path() / "visibility.bsm", ignored);
    if (!is_there)
        folder.write_pieces("visibility.bsm", [&](const OutputFolder::Sink& sink) {
            write_visibility(visibility.file, sink);
        });
    folder.write("cones.csv",
                 cones_csv(visibility.file.visibility, input.grid.solid_angles_sr));
    if (options.write_bsm_csv)
        folder.write_pieces("visibility.csv", [&](const OutputFolder::Sink& sink) {
            write_visibility_csv(visibility.map(), sink);
        });
    folder.remove_unless_written("visibility.csv");
    // Remove pictures of an earlier run, which may show a pose of another machine.
    for (const char* name : {"setup.vtp", "setup.svg", "sphere.svg"})
        folder.remove_unless_written(name);
    if (answer.setup.part_to_machine)
        write_pictures(input, visibility, answer, options, folder);
}

}  // namespace endmill
