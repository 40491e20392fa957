// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"
#include "endmill/machine/configuration.h"

namespace endmill {

/// How far a linear axis goes: the tool against the bed.
struct LinearRange {
    double from = -std::numeric_limits<double>::infinity();  ///< mm
    double to = std::numeric_limits<double>::infinity();     ///< mm, at least `from`

    /// Whether both say the same.
    friend bool operator==(const LinearRange&, const LinearRange&) = default;
};

/// Of X, Y and Z. Not given is not limited.
using LinearLimits = std::array<LinearRange, 3>;

/// Whether the axes can stand at `xyz`, in mm; the ends belong to the ranges.
bool is_within(const LinearLimits& limits, const Vec3& xyz);

/// The turn that is `turn`, in rad, but for whole turns and that `range` holds to
/// `turn_tolerance`; none if there is none.
/// \pre -pi <= turn <= pi, and the range is one of at most 2 pi that holds 0.
std::optional<double> turn_within(const RotaryRange& range, double turn);

/// The turns of the tool against the part that positions of an axis give it, or the other way
/// round: the same on the tool's side of the bed, mirrored on the part's.
/// Exact.
double mirrored(MachineSide side, double turn);

/// The same of a range: [lo, hi] becomes [-hi, -lo] on the part's side.
RotaryRange mirrored(MachineSide side, const RotaryRange& range);

/// What is expected of limits, in degrees, of a rotary axis that are not sound; nothing if they
/// are: they hold 0 and are at most 360 wide, those of the axis nearer to the tool, the tilt or
/// R2, within 180 either way.
/// \param axis 0: the axis nearer to the part, or the only one; 1: the other.
std::optional<std::string> expected_rotary_range(std::size_t axis, double from_deg,
                                                 double to_deg);

/// The one of the limits that tells of the rotary axis: of theta for the first of C,A and the
/// second of others.
/// \param axis its number from the part to the tool. \pre the configuration has it.
RotaryRange& turns_of(RotaryLimits& limits, const MachineConfiguration& configuration,
                      std::size_t axis);

/// The same of limits that stay. \pre as above
const RotaryRange& turns_of(const RotaryLimits& limits,
                            const MachineConfiguration& configuration, std::size_t axis);

/// No limits but those of the configuration: an axis that it lacks stays at 0.
RotaryLimits widest_limits(const MachineConfiguration& configuration);

}  // namespace endmill
