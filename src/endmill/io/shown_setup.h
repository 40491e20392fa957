// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A part as it is set up on a machine, for pictures.
struct ShownSetup {
    /// A rotation: its rows are the machine's X, Y and Z in coordinates of the part.
    Eigen::Matrix3d part_to_machine = Eigen::Matrix3d::Identity();
    RotaryFrame frame;    ///< the axes in coordinates of the part, at zero
    RotaryLimits needed;  ///< turns that the part asks for; each range holds 0
    std::optional<RotaryLimits> limits{};  ///< the machine's; none: not shown
};

/// What is known of each facet of a part.
struct FacetAccess {
    std::vector<double> visible_fraction;       ///< share of the sphere, 0 … 1
    std::vector<std::uint8_t> reached_at_zero;  ///< 1: without a turn of the rotary axes
};

/// What a cell of setup.vtp belongs to, and a line of the pictures. The numbers stand in files.
enum class SetupObject : std::int32_t {
    Facet = 0,  ///< of the part
    ToolAxis = 1,
    FirstAxis = 2,     ///< R1
    SecondAxis = 3,    ///< R2
    NeededMotion = 4,  ///< border of the directions within the needed turns
    MachineMotion = 5  ///< border of those within the machine's limits
};

/// A line of a picture, by directions from the middle of a sphere.
struct SetupLine {
    SetupObject object;
    DirectionCurve directions;  ///< unit, in the machine's directions
};

/// A sphere around a part.
struct PartSphere {
    Vec3 centre;    ///< mm: the middle of the part's box
    double radius;  ///< mm: a tenth more than the farthest point is away; above 0
};

/// The axes of a setup in the machine's directions.
/// \throws DomainError unless `part_to_machine` is a rotation, to 1e-9.
RotaryFrame machine_directions(const ShownSetup& setup);

/// The borders of the needed and, where they are known, of the machine's directions.
/// Source: [KangSuh, figures 5 and 12].
/// \param step as `FeasibleDirections::border`. \throws DomainError as that and
///        `machine_directions`.
std::vector<SetupLine> motion_borders(const ShownSetup& setup, double step);

/// The points of `mesh` in the machine's directions, the part's origin staying where it is.
std::vector<Vec3> posed_points(const TriangleMesh& mesh, const ShownSetup& setup);

/// The sphere around points. A single place has a radius of 1 mm.
/// \throws DomainError without a point.
PartSphere sphere_around(const std::vector<Vec3>& points);

/// What a picture calls an axis: "tool axis", or "R1 = C" after the machine's axis that it is
/// nearest to.
std::string axis_label(SetupObject object, const RotaryFrame& machine_directions);

}  // namespace endmill
