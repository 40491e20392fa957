// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

#include "endmill/core/angle.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/setup/setup.h"

// A part of two facets, and machines without rotary limits.
namespace endmill::test {

/// Two facets of a plane, accessible from within an angle of z. Their centroids are at
/// (0, 0, 0) and (90, 30, 0).
struct PlanePart {
    TriangleMesh mesh{
        {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}, {89, 29, 0}, {92, 29, 0}, {89, 32, 0}},
        {{0, 1, 2}, {3, 4, 5}}};
    SphereGrid grid = sphere_grid("hex:4");
    PartVisibility visibility{VisibilityMap{2, grid.centres.size()}, {}};

    explicit PlanePart(double within_deg = 25)
    {
        for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
            if (grid.centres[cell].z() > std::cos(Angle::degrees(within_deg).radians()))
                visibility.map.column(cell)[0] = 0b11;
    }

    PartWithCones part() const { return {mesh, grid, visibility}; }
};

/// A machine without limits of its rotary and linear axes.
inline Machine machine_of(const char* word)
{
    const MachineConfiguration configuration = configuration_from_word(word);
    return {.configuration = configuration, .rotary = widest_limits(configuration)};
}

}  // namespace endmill::test
