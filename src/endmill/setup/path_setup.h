// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/kinematics.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/machine_path_options.h"
#include "endmill/setup/clamping.h"
#include "endmill/setup/setup_pose.h"

/// \file
/// A setup of the part for a path that is planned already: the rotation of the part with
/// which a machine takes all tool axes of the path, and a clamping position.
/// Source: docs/methods/five-axis-setup.md, section 10.

namespace endmill {

/// What else a setup for a path depends on.
struct PathSetupOptions {
    /// mm, where the part's origin is clamped. Nothing: the best position is found.
    std::optional<Vec3> clamp = {};
    double tool_length = 0;           ///< mm, from the spindle nose to the tip
    Cutter cutter = Cutter::ball(5);  ///< for the tolerance of the motions

    /// If set, it is called after each rotation of the part that was tried, with their
    /// number so far and the number of all. An exception ends the search.
    std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// A setup with which a machine runs a path.
struct PathSetup {
    SetupPose pose;                   ///< axes of the machine in coordinates of the part
    Eigen::Matrix3d part_to_machine;  ///< of the pose
    ClampingFit clamping;             ///< clamping position, and slack of the linear axes
    MachinePath motions;              ///< of the machine in this setup
    std::size_t axes;                 ///< different tool axes of the path
    std::size_t poses_tried;          ///< rotations of the part, to this one
};

/// Finds a setup with which a machine runs a path as `machine_path` moves it.
///
/// 1. The part as it stands in the path is tried first.
/// 2. Then follow rotations with which all tool axes of the path are within the limits of
///    the rotary axes, those with the least sum of both rotary ranges first. The tool axis
///    of the machine is each of 1200 directions and each tool axis of the path; C,A: the
///    part is also turned about it in steps of 30 degrees, A,B: by 180 degrees.
/// 3. The first rotation is taken at which the rotary axes follow the path without a
///    retract, and X, Y and Z stay 0.1 mm or more within their limits at the best clamping
///    position, or within them at the given one. At most 500 rotations are tried.
///
/// Of more than 400 different axes one in each cube of 0.0175, about a degree, is searched for;
/// step 3 holds for all.
/// \param path    at least one point. \param machine valid, with two rotary axes.
/// \param options clamping and tool.
/// \throws DomainError as `machine_path`, or for a machine without two rotary axes that
///         tilt the tool.
/// \throws GeometryError with the point if no rotation is found: the first point whose axis
///         is out of reach together with those before; or, at the rotation that comes
///         closest, the point at which a rotary axis ends or X, Y and Z exceed their limits.
PathSetup path_setup(const ToolPath& path, const Machine& machine,
                     const PathSetupOptions& options = {});

}  // namespace endmill
