// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/answer.h"

namespace endmill {

/// A measured value with its error bound.
struct MeasuredValue {
    double value;
    std::optional<double> bound;  ///< none if the measurement has no error bound
};

/// A quantity that the simulation measures and whose value is known in closed form.
struct ClosedForm {
    std::string name;
    std::string unit;  ///< unit of the value: mm or mm^3
    double exact;
    /// Whether the measurement never exceeds the true value, so that the error lies
    /// within [-bound, 0]; otherwise it lies within [-bound, bound].
    bool is_from_below;
    /// Measures the quantity with rays or cells `pitch` mm apart. Rays are refined at
    /// most `max_refine` times; each refinement halves their distance.
    std::function<MeasuredValue(double pitch, int max_refine)> measure;
    bool can_refine;  ///< whether the measurement uses rays
};

/// The test cases of the simulation: scallops of parallel passes over a plane (also with
/// one pass left out) and along a cylinder, outside and inside; gouges of a lowered path
/// on slopes; volumes of cuts, plunges and ramps with ball, flat and bull-nose cutters.
///
/// The error bound of a volume is (pitch / 2) times the area of the vertical walls of the
/// cut, plus pitch^2 times 10 mm for its rims.
/// Source: docs/methods/removal.md, section 4.
std::vector<ClosedForm> closed_forms();

/// Whether the exact value lies within the error bound of `measured`, allowing for
/// rounding. `Undecided` if `measured` has no bound.
Answer bound_holds(const ClosedForm& form, const MeasuredValue& measured);

}  // namespace endmill
