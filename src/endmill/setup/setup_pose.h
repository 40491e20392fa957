// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/core/vec.h"
#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// How a part stands on a machine: the machine's axes in coordinates of the part, all rotary
/// axes at zero.
struct SetupPose {
    Vec3 tool_axis;  ///< unit: C, from the part towards the spindle
    Vec3
        r1_axis;  ///< unit: the first rotary axis, the nearest to the part; C,A: the tool axis
    Vec3 r2_axis;  ///< unit: the second one
};

/// A pose and the turns that it asks of the rotary axes, each of which holds 0.
struct FittedPose {
    SetupPose pose;
    RotaryRange phi;       ///< C,A: tilt [-S or -L, L or S]; A,B: R1
    RotaryRange theta;     ///< C,A: azimuths of C from r2 x C; A,B: R2
    double area;           ///< rad^2: range of phi times range of theta, the paper's F
    std::size_t cell = 0;  ///< the tool axis is the centre of this cell, where it is one
    bool is_rigid = true;  ///< false: it fits the limits only as a mirror image would
};

/// How well a set of directions can be reached, as far as one search tells.
enum class SetupStatus {
    Ok,
    ThreeAxis,        ///< one direction reaches everything: the area is 0
    FourAxis,         ///< a great arc does: the area is 0
    NoOpenHemisphere  ///< no pose has all directions within 90 degrees of its tool axis
};

/// What a search over poses finds. Source: [KangSuh, sections 4 to 6].
struct SetupSearch {
    SetupStatus status = SetupStatus::Ok;
    std::optional<FittedPose> least;     ///< of all poses, whatever the limits: MAR
    std::optional<FittedPose> feasible;  ///< the best within the limits
    std::size_t poses_tried = 0;
    std::size_t poses_skipped =
        0;  ///< without a hull: directions not in an open hemisphere
};

}  // namespace endmill
