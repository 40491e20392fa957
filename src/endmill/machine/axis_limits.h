// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"
#include "endmill/machine/configuration.h"

/// \file
/// Travel limits of linear and rotary axes.
///
/// A *turn* is a rotation of the tool against the part, by the right-hand rule about +X,
/// +Y or +Z. A *position* is the rotation of the body that the axis carries (part or
/// tool), by the same rule. Turn and position are equal on the tool's side of the bed,
/// and have opposite signs on the part's side. The library computes with turns; machine
/// files and controllers use positions.
/// Source: docs/methods/five-axis-setup.md, section 2.

namespace endmill {

/// Interval of turns of one rotary axis. The default is a full rotation.
struct RotaryRange {
    double from = -std::numbers::pi;  ///< rad, at most 0
    double to = std::numbers::pi;     ///< rad, at least 0 and at most 2 pi above `from`

    /// Compares both ends exactly.
    friend bool operator==(const RotaryRange&, const RotaryRange&) = default;
};

/// Limits of the two rotary axes as turns. The default does not limit either.
///
/// On a C,A machine phi is the tilt (second letter), on an A,B machine it is the turn of
/// R1 (first letter). theta belongs to the other letter. On a four-axis machine phi is
/// the only rotary axis, and theta is 0.
struct RotaryLimits {
    RotaryRange phi = {};    ///< C,A: tilt, second letter; A,B: R1, first letter
    RotaryRange theta = {};  ///< C,A: turn of C, first letter; A,B: R2, second letter

    /// Compares both ranges exactly.
    friend bool operator==(const RotaryLimits&, const RotaryLimits&) = default;
};

/// Travel of one linear axis, of the tool against the bed. The default does not limit it.
struct LinearRange {
    double from = -std::numeric_limits<double>::infinity();  ///< mm
    double to = std::numeric_limits<double>::infinity();     ///< mm, at least `from`

    /// Compares both ends exactly.
    friend bool operator==(const LinearRange&, const LinearRange&) = default;
};

/// Travel of X, Y and Z.
using LinearLimits = std::array<LinearRange, 3>;

/// Tests whether the linear axes can reach a position. The ends belong to the ranges.
/// \param limits travel of X, Y, Z.
/// \param xyz position in mm.
bool is_within(const LinearLimits& limits, const Vec3& xyz);

/// Finds the turn that differs from `turn` by full rotations and lies within `range`, to
/// `turn_tolerance`.
/// \param range at most 2 pi wide; it contains 0.
/// \param turn rad, within [-pi, pi].
/// \return rad, or nothing if no such turn lies within the range.
std::optional<double> turn_within(const RotaryRange& range, double turn);

/// Converts a position of an axis to the turn that it causes, or a turn to its position.
/// The sign changes on the part's side of the bed. Exact.
/// \param side side of the axis.
/// \param turn rad.
double mirrored(MachineSide side, double turn);

/// Converts a range of positions to turns, or back: [lo, hi] becomes [-hi, -lo] on the
/// part's side. Exact.
RotaryRange mirrored(MachineSide side, const RotaryRange& range);

/// Checks the limits of a rotary axis, in degrees, as a file or an option gives them.
/// They must contain 0 and be at most 360 degrees wide. The axis next to the tool (the
/// tilt of C,A, R2 of A,B) must stay within 180 degrees to either side.
/// \param axis 0 for the axis nearer to the part, or the only one; 1 for the other axis.
/// \param from_deg lower limit. \param to_deg upper limit.
/// \return a description of what is expected, or nothing if the limits are valid.
std::optional<std::string> expected_rotary_range(std::size_t axis, double from_deg,
                                                 double to_deg);

/// Reduces a range of turns to the part from which directions are computed: a full
/// rotation of the axis nearer to the part becomes [-pi, pi], and the other axis is cut to
/// it. Ranges that `expected_rotary_range` accepts stay as they are.
/// \param axis as there. \param range rad; it contains 0.
RotaryRange within_one_rotation(std::size_t axis, const RotaryRange& range);

/// Selects the limits of one rotary axis: theta for the first axis of C,A and the second
/// axis of A,B, else phi.
/// \param limits turns. \param configuration the machine.
/// \param axis index from the part to the tool. \pre the configuration has this axis.
RotaryRange& turns_of(RotaryLimits& limits, const MachineConfiguration& configuration,
                      std::size_t axis);

/// The same for limits that cannot be changed.
const RotaryRange& turns_of(const RotaryLimits& limits,
                            const MachineConfiguration& configuration, std::size_t axis);

/// Limits that restrict nothing: a full rotation for each rotary axis of the machine, and
/// [0, 0] for an axis that the machine lacks.
RotaryLimits widest_limits(const MachineConfiguration& configuration);

}  // namespace endmill
