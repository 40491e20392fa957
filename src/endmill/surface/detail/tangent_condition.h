// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/surface/continuity.h"

namespace endmill {

/// How far a border between patches meets the sufficient condition for tangent continuity
/// that [KimChoi, fig. 11] shows: the legs of the net on both sides of each joint lie on
/// one line, and their lengths have one ratio along the whole line of joints.
struct TangentCondition {
    std::string border;     ///< such as "u=1": the whole border, through all patches
    double least_ratio;     ///< of the leg beyond the joint to the one before it
    double greatest_ratio;  ///< equal to the least where the condition holds
    Angle worst_bend;       ///< greatest angle between the two legs at a joint
    BorderBreak measured;   ///< the worst break of the surface's normals there
};

/// The condition at each inner border, first those across u, then those across v.
/// \throws DomainError if a leg of the net at a border has no length.
std::vector<TangentCondition> tangent_conditions(const Surface& surface);

}  // namespace endmill
