// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/setup_pictures.h"

#include <algorithm>

#include "endmill/io/setup_svg.h"
#include "endmill/io/sphere_svg.h"

namespace endmill {

void write_setup_pictures(Experiment& run, const std::string& name,
                          const StudiedPart& part, const ShownSetup& setup,
                          const std::vector<Vec3>& marked)
{
    const auto nearest = std::ranges::max_element(
        part.grid.centres, {},
        [&](const Vec3& centre) { return centre.dot(setup.frame.tool_axis); });
    const auto cell = static_cast<std::size_t>(nearest - part.grid.centres.begin());
    std::vector<std::uint8_t> reached;
    for (std::size_t j = 0; j < part.mesh.triangles().size(); ++j)
        reached.push_back(part.visibility.map.is_accessible(j, cell) ? 1 : 0);
    run.write(name + "-setup.svg", setup_svg(part.mesh, reached, setup, {.title = name}));
    SphereFigure sphere{.title = name};
    sphere.setup = setup;
    sphere.marked = marked;
    run.write(name + "-sphere.svg", sphere_svg(part.grid, part.visibility.map, sphere));
}

}  // namespace endmill
