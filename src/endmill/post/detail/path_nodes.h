// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "endmill/machine/kinematics.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/detail/branch_search.h"
#include "endmill/post/machine_path.h"

namespace endmill {

/// "point 3 of the path", for messages.
std::string point_of_path(std::size_t row);

/// An angle in degrees with up to six decimals, for messages.
std::string degrees_text(double radians);

/// A pose on a path, with what the search for positions needs. Between nodes the tip moves
/// on a straight line and the axis on a great arc, evenly.
struct PathNode {
    CutterLocation pose;  ///< in the part
    std::size_t row;      ///< index of the point of the path at the end of this move
    bool is_row_end;      ///< whether the node is that point
    /// Sine of the angle between the axis and the nearest singular direction; 1 on a machine
    /// without one.
    double distance_from_singular;
    std::array<RotaryPositions, 2> solutions;  ///< rad, up to full rotations
    std::size_t branches;                      ///< number of solutions

    /// Whether the first rotary axis has no effect.
    bool is_singular() const { return distance_from_singular <= turn_tolerance; }
};

/// The nodes of a path: its points, and points between them where an axis turns far, so
/// that between nodes every axis turns by less than 90 degrees. With SingularRule::Turn and
/// SingularRule::Retract an axis within the singular cone is replaced by the singular
/// direction, and the reference point stays.
struct PathNodes {
    std::vector<PathNode> nodes;      ///< in order
    std::size_t singular_points = 0;  ///< number of nodes whose axis was replaced
};

/// The nodes of `path`, whose points are poses joined by linear motion.
/// \throws GeometryError with the point for opposite axes of neighbours, and for an axis
///         that no position of the rotary axes gives.
PathNodes path_nodes(const ToolPath& path, const PartOnMachine& setup,
                     const MachinePathOptions& options);

/// The poses for `search_branches`. A run of nodes in one singular direction keeps the
/// position of the first axis until its last node, where the axis turns to where the path
/// goes on.
/// \param may_retract whether the tool may retract at every node.
std::vector<SearchPose> search_poses(const std::vector<PathNode>& nodes,
                                     const ToolPath& path,
                                     const MachinePathOptions& options, bool may_retract);

}  // namespace endmill
