// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The family of a machine. Words without two rotary axes count as A,B: the only rotary
/// axis of four is phi, as R1.
RotaryFamily family_of(const MachineConfiguration& configuration);

/// The machine for which poses are sampled, and what orders them.
struct PoseSampling {
    RotaryReach reach = {};                 ///< the machine; its configuration is valid
    SetupMode mode = SetupMode::Corrected;  ///< of five axes: any but `WholeCones`
    /// Orders the poses by this measure; nothing: by their area.
    std::optional<PoseMeasure> measure = {};
    /// Used with five axes, as PoseFitOptions::nearest_cells.
    NearestCellsFinder nearest_cells = for_each_nearest_cells;
};

/// The value by which a pose is ordered: rad^2, or rad.
double objective_of(const FittedPose& pose, const PoseSampling& sampling);

/// The rotary axes that are tried for a machine of four axes, unit: cell centres 2.7
/// degrees apart, half a cell of a sphere of 1200 cells.
std::vector<Vec3> four_axis_axes();

/// The pose of a machine of three axes whose tool axis is the centre of a cell.
FittedPose pose_without_rotary_axes(const SphereGrid& grid, std::size_t cell);

/// Whether two poses have the same axes, to the bit.
bool is_same_pose(const SetupPose& one, const SetupPose& other);

/// Poses within the rotary limits that reach every facet, in the order of the objective;
/// of equal ones that with the smaller sum of ranges first.
///
/// - Five axes: the pose of least area at each tool axis, found by the mode. C,A: also
///   this pose turned about its tool axis in steps of 30 degrees, A,B: by 180 degrees,
///   where the ranges stay within the limits.
/// - Four axes: the shortest arc about each axis of `four_axis_axes`.
/// - Three axes: each cell from which every facet is reached, in steps of 5 degrees about
///   it. A turn by 180 degrees would need the same travel.
/// \param grid cells. \param visibility cones of the facets. \param sampling machine and
///         order.
std::vector<FittedPose> sampled_poses(const SphereGrid& grid,
                                      const PartVisibility& visibility,
                                      const PoseSampling& sampling);

}  // namespace endmill
