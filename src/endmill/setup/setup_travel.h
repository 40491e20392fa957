// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/kinematics.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Travel of the linear axes for a setup: the direction from which the tool reaches each
/// facet, and the positions of X, Y and Z there. The paper names this as future work.
/// Source: docs/methods/five-axis-setup.md, section 10.

namespace endmill {

/// The rotation that sets a part up, x_machine = M x_part. The rows of M are the
/// machine's X, Y and Z in coordinates of the part.
/// Source: [KangSuh, section 2]; docs/methods/five-axis-setup.md, section 2.
/// \throws DomainError if the configuration is not valid.
Eigen::Matrix3d part_to_machine(const SetupPose& pose,
                                const MachineConfiguration& configuration);

/// The direction from which a facet is reached.
struct FacetReach {
    std::size_t cell;     ///< its centre is the direction
    RotaryAngles angles;  ///< rotations that give this direction
};

/// Chooses for each facet the accessible cell within the limits that needs the least
/// |phi| + |theta|. A direction has two solutions, of which the smaller one counts. Among
/// equal cells the lowest one is chosen. O(cells * facets / 64).
/// \param map accessible cells of each facet.
/// \param centres unit, one for each cell of `map`.
/// \param frame axes of the machine in coordinates of the part.
/// \param limits of the rotations.
/// \return one entry for each facet, empty for a facet that no cell within the limits
///         reaches.
/// \throws DomainError if there is not one centre for each cell.
std::vector<std::optional<FacetReach>> facet_reach(const VisibilityMap& map,
                                                   std::span<const Vec3> centres,
                                                   const RotaryFrame& frame,
                                                   const RotaryLimits& limits);

/// Points of a part, and for each of them the rotations with which the tool reaches it.
struct ReachedPoints {
    std::vector<Vec3> points;          ///< mm, coordinates of the part
    std::vector<RotaryAngles> angles;  ///< one for each point
};

/// The centroids of the facets that a pose reaches, with the rotations of `facet_reach`.
/// \param part the mesh that `visibility` belongs to.
/// \param visibility cones of its facets. \param centres unit, one for each cell.
/// \param frame axes of the machine in coordinates of the part. \param limits of the
///         rotations.
/// \return nothing if the pose reaches no facet, or misses a facet that has an area.
/// \throws DomainError as `facet_reach`.
std::optional<ReachedPoints> reached_points(const TriangleMesh& part,
                                            const PartVisibility& visibility,
                                            std::span<const Vec3> centres,
                                            const RotaryFrame& frame,
                                            const RotaryLimits& limits);

/// Positions of the machine's rotary axes for rotations of the tool against the part.
/// \param configuration valid.
RotaryPositions rotary_positions(const MachineConfiguration& configuration,
                                 const RotaryAngles& angles);

/// Travel of the linear axes for a setup.
struct SetupTravel {
    Vec3 low;            ///< mm, least X, Y and Z over all points
    Vec3 high;           ///< mm, largest X, Y and Z over all points
    bool is_within;      ///< all positions lie within the machine's linear limits
    Vec3 centred_clamp;  ///< mm, best clamping position: see `setup_travel`
};

/// Computes the travel of X, Y and Z while the tip goes to each of the points.
///
/// The centred clamp minimises the sum of the squared distances between the positions and
/// the middle of the travel. The middle of an axis without limits is 0.
/// \param machine valid.
/// \param part_to_machine rotation of the part, from the function of this name.
/// \param reached points and rotations. \param clamp position of the part's origin, mm,
///         in the machine's directions. \param tool_length mm, from the spindle nose to
///         the tip.
/// \throws DomainError if there is no point, or not one pair of rotations for each point.
SetupTravel setup_travel(const Machine& machine, const Eigen::Matrix3d& part_to_machine,
                         const ReachedPoints& reached, const Vec3& clamp,
                         double tool_length);

}  // namespace endmill
