// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/kinematics.h"

/// \file
/// How a part stands on a machine, and what a search over poses reports.

namespace endmill {

/// A pose of the part on the machine: the machine's axes in coordinates of the part, with
/// all rotary axes at zero.
struct SetupPose {
    Vec3 tool_axis;  ///< unit: C, from the part towards the spindle
    Vec3 r1_axis;    ///< unit: the rotary axis nearest to the part; C,A: the tool axis
    Vec3 r2_axis;    ///< unit: the other rotary axis
};

/// A pose and the ranges of turns that it needs. Both ranges contain 0.
struct FittedPose {
    SetupPose pose;        ///< axes in coordinates of the part
    RotaryRange phi;       ///< rad; C,A: tilt; A,B: turn of R1
    RotaryRange theta;     ///< rad; C,A: turn of C, azimuth 0 is r2 x C; A,B: turn of R2
    double area;           ///< rad^2: range of phi times range of theta, the paper's F
    std::size_t cell = 0;  ///< the cell whose centre is the tool axis; 0 if there is none
    bool is_rigid = true;  ///< false: only a mirror image of the part fits the limits
};

/// [S, L]: the smaller and the larger magnitude of the ends of a range, in rad.
/// Source: [KangSuh, eq. (10), (19)].
std::array<double, 2> magnitudes(const RotaryRange& range);

/// How many axes move in a setup.
enum class SetupStatus {
    Ok,         ///< two rotary axes move
    ThreeAxis,  ///< no rotary axis moves: one direction reaches everything, the area is 0
    FourAxis,   ///< one rotary axis moves: an arc of a great circle, the area is 0
    NoOpenHemisphere  ///< no pose has all directions within 90 degrees of its tool axis
};

/// What a search over tool axes reports. Source: [KangSuh, sections 4 to 6].
struct PoseSearchResult {
    SetupStatus status =
        SetupStatus::Ok;                 ///< of `feasible` if it is set, else of `least`
    std::optional<FittedPose> least;     ///< the best pose without limits: MAR
    std::optional<FittedPose> feasible;  ///< the best pose within the limits
    std::size_t poses_tried = 0;         ///< number of tool axes
    std::size_t poses_skipped =
        0;  ///< tool axes without a fit: directions 90 degrees off
};

/// The rotary axes of a machine, as far as a setup depends on them.
struct RotaryReach {
    MachineConfiguration configuration = {};  ///< axes of the machine
    RotaryLimits limits =
        {};  ///< turns of the tool against the part; of four axes phi counts

    /// Four axes: a cell counts if its centre lies this close to the arc of tool
    /// directions. The default is half a cell of a sphere of 1200 cells.
    Angle arc_tolerance = Angle::degrees(2.95);
};

/// Returns true if the rotary axes are B, then A. Such words have r2 = r1 x C, all other
/// words of the family A,B have r2 = C x r1.
bool is_b_first(const MachineConfiguration& configuration);

/// The axes of a machine on which the part stands in `pose`, in coordinates of the part.
/// A machine with fewer than two rotary axes counts as A,B with R2 at rest.
RotaryFrame pose_frame(const MachineConfiguration& configuration, const SetupPose& pose);

/// The limits within which a cell counts as reached in the frame of `pose_frame`. With
/// four axes theta is the arc tolerance to either side, with three axes it is 0.
RotaryLimits cell_limits(const RotaryReach& reach);

}  // namespace endmill
