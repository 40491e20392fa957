// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the setup of a part on a five-axis machine with the least rotary ranges.

#include <exception>
#include <iostream>

#include "endmill/files.h"
#include "endmill/setup.h"

int main()
try {
    using namespace endmill;
    const Part part = read_part("datasets/meshes/teapot-288.off").part;
    const SphereGrid grid = sphere_grid("hex:10");
    const PartVisibility visibility =
        part_visibility(std::get<TriangleMesh>(part), grid.centres, {});

    SetupRequest request;
    request.reach.configuration = configuration_from_word("W/caxyBz/T");
    request.mode = SetupMode::Corrected;
    const PartSetup setup = find_setup(grid, visibility, request);
    if (!setup.shown())
        return 1;
    const FittedPose& fit = *setup.shown();
    std::cout << "tool axis " << fit.pose.tool_axis.transpose() << ", tilt from "
              << Angle::radians(fit.phi.from).degrees() << " to "
              << Angle::radians(fit.phi.to).degrees() << " degrees\n";
} catch (const std::exception& error) {
    std::cerr << "setup: " << error.what() << '\n';
    return 2;
}
