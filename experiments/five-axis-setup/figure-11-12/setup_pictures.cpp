// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/figure-11-12/setup_pictures.h"

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
    run.write(names.file + "-setup.svg",
              setup_svg(part.mesh, reached, setup,
                        {.title = names.title, .captions = names.captions}));
    SphereFigure sphere{.title = names.title, .captions = names.captions};
    sphere.setup = setup;
    sphere.marked = marked;
    run.write(names.file + "-sphere.svg",
              sphere_svg(part.grid, part.visibility.map, sphere));
}

}  // namespace endmill
