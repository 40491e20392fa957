// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/offset/section_curve.h"
#include "endmill/trimming/trimming.h"
#include "endmill/trimming/trimming_quality.h"

namespace endmill {

/// A curve to trim and the tolerances of a correct result.
struct TrimmingTrial {
    SectionCurve curve;
    TrimmingTolerance tolerance;
    /// Gouge allowed to method 1, replaces that of `tolerance`.
    double scan_gouge_mm = 0;
    double scan_step_mm = 0;       ///< scan step of method 1
    double scan_threshold_mm = 0;  ///< distance below which method 1 accepts a crossing
};

/// A trimming method with its way of fold detection.
struct TriedMethod {
    std::string label;   ///< name of a column, such as "literal 1"
    std::string method;  ///< a name in `trimming_methods`
    FoldDetection detection;
    FoldPatterns patterns = FoldPatterns::P3AndP4;  ///< for literal detection
};

/// All trimming methods. A method with two ways of detection occurs twice: literal and
/// guarded.
std::vector<TriedMethod> tried_methods();

/// Number of `trials` that `method` trims wrongly: the result exceeds a tolerance of the
/// trial. Uses all threads. \throws DomainError if there is no such method.
std::size_t wrong_curves(std::span<const TrimmingTrial> trials,
                         const TriedMethod& method);

/// Number of curves that cross themselves: the ends of a segment lie strictly on
/// different sides of another segment, and vice versa. The predicate is exact.
std::size_t crossing_curves(std::span<const TrimmingTrial> trials);

}  // namespace endmill
