// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/surface/continuity.h"

namespace endmill {

/// Deviation of a border between patches from the sufficient condition for tangent
/// continuity in [KimChoi, fig. 11]: at each joint the control point of the border and
/// its two neighbours across the border are collinear, and the ratio of their distances
/// is constant along the border.
struct TangentCondition {
    std::string border;     ///< such as "u=1": the border through all patches
    double least_ratio;     ///< least distance beyond the joint / distance before it
    double greatest_ratio;  ///< equal to the least ratio if the condition holds
    Angle worst_bend;       ///< largest angle between the two legs at a joint
    /// The largest angle between the normals of the patches at the border.
    BorderBreak measured;
};

/// The condition at each inner border: first the borders of constant u, then those of
/// constant v.
/// \throws DomainError if two neighbouring control points across a border coincide.
std::vector<TangentCondition> tangent_conditions(const Surface& surface);

}  // namespace endmill
