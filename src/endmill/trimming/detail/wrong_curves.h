// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/offset/section_curve.h"
#include "endmill/trimming/trimming.h"
#include "endmill/trimming/trimming_quality.h"

namespace endmill {

/// A curve to be trimmed by itself, and what a result of it may be off.
struct TrimmingTrial {
    SectionCurve curve;
    TrimmingTolerance tolerance;
    double scan_gouge_mm = 0;      ///< allowed to method 1 in place of the tolerance's
    double scan_step_mm = 0;       ///< of method 1
    double scan_threshold_mm = 0;  ///< of method 1
};

/// A method as it is tried: by its name among `trimming_methods` and its detection.
struct TriedMethod {
    std::string label;  ///< of a column, such as "literal 1"
    std::string method;
    FoldDetection detection;
    FoldPatterns patterns = FoldPatterns::P3AndP4;  ///< with literal detection
};

/// All methods, those that have two ways of detection both ways.
std::vector<TriedMethod> tried_methods();

/// How many of `trials` come out wrong by `method`, on all threads.
std::size_t wrong_curves(std::span<const TrimmingTrial> trials,
                         const TriedMethod& method);

/// How many curves cross themselves: two segments that are no neighbours have their ends
/// strictly on different sides of each other. Decided exactly.
std::size_t crossing_curves(std::span<const TrimmingTrial> trials);

}  // namespace endmill
