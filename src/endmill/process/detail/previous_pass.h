// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/process/ball_engagement.h"

namespace endmill {

/// A point of BorderKind::PreviousBall, by the angle phi about the previous pass's axis from
/// its lowest line: y = sin phi - a, w = -b - cos phi.
struct PassPoint {
    double sine;      ///< of phi
    double cosine;    ///< of phi
    double tau;       ///< distance in front of the front plane
    double tau_by_x;  ///< derivative by the border's angle x
    double phi_by_x;  ///< ditto
};

/// The point at p = tan(x/2). \pre there is a previous pass, of a pick feed below 2.
PassPoint pass_point(const EngagedRegion& region, double p);

/// p of the point with u = tan(phi/2); the nearer end where that is behind the front plane.
double pass_parameter(const EngagedRegion& region, double u);

/// The condition base + turn cos(phi) + front tau > 0 on the previous pass.
struct PassCondition {
    double base;
    double turn;
    double front;
};

/// Where a condition changes its sign along the previous pass.
struct SignChanges {
    std::array<double, 8> at;  ///< p, rising; the first `count` hold
    int count = 0;
    bool is_positive = false;  ///< whether the condition holds before the first
};

/// The changes between the border's begin and p = 1. The condition squared is a quartic in
/// tan(phi/2); between its stations the sign is that of the middle, and a change is solved
/// for by Newton's steps in p, to its rounding. Changes closer than about 1e-8 may be missed.
/// Source: derived in paper/notes/ball-engagement.md, section 2.
SignChanges sign_changes(const EngagedRegion& region, const PassCondition& condition);

}  // namespace endmill
