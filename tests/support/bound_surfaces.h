// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/bound/bound_problem.h"
#include "endmill/bound/detail/contact_frame.h"
#include "endmill/files/surface_file.h"
#include "endmill/surface/tool_side.h"

// Surfaces of datasets with the sides of the tool, and problems for them.
namespace endmill::test {

/// Surfaces with the signs of their normals.
struct SidedSurfaces {
    std::vector<Surface> surfaces;
    std::vector<double> sides;

    explicit SidedSurfaces(std::vector<Surface> all)
        : surfaces{std::move(all)},
          sides{tool_side_signs(surfaces, Vec3::UnitZ())}
    {
    }

    BoundedPart part() const { return {surfaces, sides}; }
};

/// The surfaces of datasets/surfaces/NAME.json.
inline SidedSurfaces dataset(const std::string& name)
{
    return SidedSurfaces{
        read_surface(ENDMILL_SOURCE_DIR "/datasets/surfaces/" + name + ".json").surfaces};
}

/// A ball of radius 7.5 mm that may leave 0.5 mm.
inline BoundProblem usual_problem()
{
    return {BallCutter{7.5}, 0.5};
}

/// The same for the travel of tips.
inline BoundProblem tip_problem()
{
    BoundProblem problem = usual_problem();
    problem.length = BoundedLength::Tip;
    return problem;
}

}  // namespace endmill::test
