// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/figure-11-12/setup_pictures.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/text.h"
#include "endmill/figures/setup_figures.h"

namespace endmill {
namespace {

std::string tenths(double angle)
{
    return to_text(std::round(10 * Angle::radians(angle).degrees()) / 10) + "°";
}

std::string shown(const std::string& axis, const RotaryRange& range)
{
    return axis + " from " + tenths(range.from) + " to " + tenths(range.to);
}

// Which way the tool axis leans in the part's frame, and the mounted part.
std::string lean_caption(const Vec3& tool_axis)
{
    const bool is_to_spout = tool_axis.x() > 0;
    const std::string spout = "the spout (+x)";
    const std::string handle = "the handle (-x)";
    return "tool axis " + tenths(std::acos(std::min(1.0, tool_axis.z()))) +
           " from the pot's z: it leans to " + (is_to_spout ? spout : handle) +
           ", so that the mounted pot leans to " + (is_to_spout ? handle : spout);
}

// The azimuth from which the angle between the tool axis and the part's z is seen in full.
Angle across_the_lean(const ShownSetup& setup)
{
    const Vec3 z = setup.part_to_machine.col(2);
    return Angle::radians(std::atan2(z.y(), z.x()) - Angle::degrees(90).radians());
}

}  // namespace

std::string range_caption(RotaryFamily family, const FittedPose& fit)
{
    const bool is_ca = family == RotaryFamily::CA;
    return shown(is_ca ? "tilt" : "R1", fit.phi) + ", " +
           shown(is_ca ? "C" : "R2", fit.theta);
}

void write_setup_pictures(Experiment& run, const SetupPictureNames& names,
                          const StudiedPart& part, const ShownSetup& setup,
                          const std::vector<Vec3>& marked)
{
    const std::vector<std::uint8_t> reached =
        reached_at_zero(part.grid, part.visibility.map, setup.frame.tool_axis);
    std::vector<std::string> captions = names.captions;
    captions.push_back(lean_caption(setup.frame.tool_axis));
    run.write(names.file + "-setup.svg",
              setup_svg(part.mesh, reached, setup,
                        {.title = names.title,
                         .captions = captions,
                         .azimuth = across_the_lean(setup),
                         .elevation = Angle::degrees(12),
                         .part_axis_names = {"x, spout", "", "z, lid"}}));
    SphereFigure sphere{.title = names.title, .captions = names.captions};
    sphere.setup = setup;
    sphere.marked = marked;
    run.write(names.file + "-sphere.svg",
              sphere_svg(part.grid, part.visibility.map, sphere));
}

}  // namespace endmill
