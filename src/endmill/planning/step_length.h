// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "endmill/core/angle.h"

/// \file
/// The longest straight step along a curve that keeps a chord tolerance.

namespace endmill {

/// Whether a length is the value of its formula.
enum class LengthStatus {
    Ok,         ///< the value of the formula
    Clamped,    ///< the value at the limit of the formula's range of validity
    Unlimited,  ///< every length is allowed; the stored lengths are infinite
};

/// The name of `status` in files: "ok", "clamped" or "unlimited".
std::string_view length_status_name(LengthStatus status);

/// A straight step along a curve.
struct StepLength {
    double chord;      ///< L in mm, distance to the next point
    double projected;  ///< D in mm, projection of the chord on the tangent at its start
    Angle half_angle;  ///< theta: half the chord's angle at the centre of curvature
    LengthStatus status;  ///< whether the formula or a limit determined the values
};

/// Longest step whose chord stays within `chord_tolerance` of a curve. The curve is taken
/// as the circle of its curvature k at the start: L = 2 sqrt(2 delta/k - delta^2), D = L
/// (1 - k delta). Beyond a half angle of 45 degrees, D decreases as delta grows. A longer
/// step is therefore clamped to L = sqrt(2)/k, D = 1/k.
/// Source: [KimChoi, eq. (1), (2)], written in curvature; the clamp is an addition, see
/// docs/methods/economic-cl-data.md, section 4.
///
/// \param curvature       k in 1/mm; its sign does not matter; 0 gives Unlimited.
/// \param chord_tolerance delta in mm.
/// \throws DomainError unless both are finite and 0 < delta.
///
/// Relative error below 1e-14.
StepLength step_length(double curvature, double chord_tolerance);

}  // namespace endmill
