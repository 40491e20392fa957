// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace endmill {

/// A measured number and how far the true one may be from it.
struct Measured {
    double value;
    std::optional<double> bound;  ///< none where nothing is stated
};

/// Something that the simulation measures and that is known in closed form.
struct ClosedForm {
    std::string name;
    std::string unit;  ///< of its number: mm or mm^3
    double exact;
    /// Whether the true number is `bound` greater at most and never less; else it may be
    /// either.
    bool is_from_below;
    /// Measures it with rays or cells `pitch` mm apart, halved `max_refine` times at most.
    std::function<Measured(double pitch, int max_refine)> measure;
    bool can_refine;  ///< whether it is measured by rays, which may be halved
};

/// Scallops of parallel passes over a plane and along a cylinder, outside and inside, and
/// of a pass left out; gouges of a lowered path on slopes; volumes of cuts, plunges and
/// ramps of ball, flat and bull-nose.
/// Source: spec of the removal, section 4. The bound of a volume is half a cell of its
/// upright walls and 10 mm of rims, a square of the pitch each, as its tests hold it to.
std::vector<ClosedForm> closed_forms();

/// Whether `measured` is the true number within its bound and rounding; nothing if it has
/// no bound.
std::optional<bool> bound_holds(const ClosedForm& form, const Measured& measured);

}  // namespace endmill
