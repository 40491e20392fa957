// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/kinematics.h"
#include "endmill/machine/rotary_angles.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The rotation that sets a part up: rows are the machine's X, Y and Z in coordinates of the
/// part, so that x_machine = M x_part. Source: [KangSuh, section 2], the pose written out.
/// \throws DomainError unless the configuration is valid.
Eigen::Matrix3d part_to_machine(const SetupPose& pose,
                                const MachineConfiguration& configuration);

/// How a facet is reached.
struct FacetReach {
    std::size_t cell;     ///< along its centre
    RotaryAngles angles;  ///< the turns that it asks for
};

/// For each facet the accessible cell within `limits` that needs the least |phi| + |theta|, in
/// the turns that need less; of equal ones the lowest cell. None for a facet without one.
/// O(cells facets / 64). \pre the frame's axes are unit, centres too, one for each cell.
std::vector<std::optional<FacetReach>> facet_reach(const VisibilityMap& map,
                                                   std::span<const Vec3> centres,
                                                   const RotaryFrame& frame,
                                                   const RotaryLimits& limits);

/// Where the linear axes go for a setup.
struct SetupTravel {
    Vec3 low;            ///< mm, least X, Y, Z of all facets
    Vec3 high;           ///< mm, largest
    bool is_within;      ///< the machine's linear limits
    Vec3 centred_clamp;  ///< mm, see `setup_travel`
};

/// What is to be moved: points of a part, each with the turns under which it is reached.
struct ReachedPoints {
    std::vector<Vec3> points;          ///< mm, coordinates of the part
    std::vector<RotaryAngles> angles;  ///< one a point
};

/// Travel of the linear axes while the tip is at each of the points, the part's origin
/// clamped at `clamp`, in mm and the machine's directions. The centred clamp is where the
/// squared distances of X, Y and Z from the middle of their travel (0 of axes that are not
/// limited) add up to the least.
/// \param tool_length mm, from spindle to tip.
/// \throws DomainError without a point, or as `part_to_machine`.
SetupTravel setup_travel(const Machine& machine, const Eigen::Matrix3d& part_to_machine,
                         const ReachedPoints& reached, const Vec3& clamp,
                         double tool_length);

}  // namespace endmill
