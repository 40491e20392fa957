// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/studied_part.h"

#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/setup/setup_travel.h"
#include "endmill/visibility/visibility.h"
#include "support/dataset_mesh.h"

namespace endmill {

StudiedPart studied_part(TriangleMesh mesh, const std::string& grid, Angle incidence,
                         VisibilityKind kind)
{
    StudiedPart part{std::move(mesh), sphere_grid(grid), {}};
    VisibilityOptions options;
    options.incidence = incidence;
    options.kind = kind;
    part.visibility = part_visibility(part.mesh, part.grid.centres, options);
    return part;
}

StudiedPart studied_part(const std::string& file, const std::string& grid,
                         Angle incidence)
{
    return studied_part(dataset_mesh(file), grid, incidence);
}

PartSetup unlimited_setup(const StudiedPart& part, RotaryFamily family,
                          const std::string& mode)
{
    const std::optional<SetupMode> known = setup_mode(mode);
    require(known.has_value(), "unlimited_setup: need the word of a mode");
    return five_axis_setup(
        part.grid, part.visibility.map,
        {.reach = {.configuration = configuration_of_family(family)}, .mode = *known});
}

ShownSetup posed(RotaryFamily family, const FittedPose& fit)
{
    const MachineConfiguration configuration = configuration_of_family(family);
    return {part_to_machine(fit.pose, configuration),
            pose_frame(configuration, fit.pose),
            {fit.phi, fit.theta},
            {}};
}

std::vector<Vec3> nearest_directions(const StudiedPart& part, const FittedPose& fit)
{
    std::vector<Vec3> directions;
    for (const std::size_t cell :
         nearest_cells(part.visibility.map, part.grid.centres, fit.cell))
        directions.push_back(part.grid.centres[cell]);
    return directions;
}

std::string family_name(RotaryFamily family)
{
    return family == RotaryFamily::CA ? "C,A" : "A,B";
}

}  // namespace endmill
