// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "endmill/core/angle.h"

namespace endmill {

/// Whether a length is what the formula gives.
enum class LengthStatus {
    Ok,         ///< the formula's value
    Clamped,    ///< the value at the limit of the formula's meaning
    Unlimited,  ///< no length is too long; the lengths are infinite
};

/// "ok", "clamped" or "unlimited".
std::string_view length_status_name(LengthStatus status);

/// How far the cutter may go straight along a curve.
struct StepLength {
    double chord;      ///< L in mm, straight to the next point
    double projected;  ///< D in mm, of the chord onto the tangent at its start
    Angle half_angle;  ///< that the chord spans at the centre of curvature
    LengthStatus status;
};

/// Longest step whose chord stays within `chord_tolerance` of a curve, taken as a circle
/// of its curvature k at the start: L = 2 sqrt(2 delta/k - delta^2), D = L (1 - k delta).
/// Beyond 45 degrees D would fall again as delta grows; the step is clamped there to
/// L = sqrt(2)/k, D = 1/k.
/// Source: [KimChoi, eq. (1), (2)], written in curvature; the clamp is ours.
///
/// \param curvature       k in 1/mm; its sign does not matter; 0 gives Unlimited.
/// \param chord_tolerance delta in mm.
/// \throws DomainError unless both are finite and 0 < delta.
/// Relative error below 1e-14.
StepLength step_length(double curvature, double chord_tolerance);

}  // namespace endmill
