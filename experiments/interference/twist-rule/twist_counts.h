// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/trimming/detail/wrong_curves.h"

namespace endmill {

/// Number of curves for which the paper's rules on twists hold or fail.
struct TwistCounts {
    std::size_t crossing = 0;  ///< curves that cross themselves
    /// Of these, curves along which the signs of dz never read - + - +.
    std::size_t without_three_changes = 0;
    std::size_t three_runs = 0;                   ///< curves along which they read + - +
    std::size_t three_runs_without_crossing = 0;  ///< of these, curves without a crossing
    /// Curves with a crossing, although no line through a segment behind the first fold,
    /// to the end of the curve, meets branch A of that fold.
    std::size_t no_line_meets_a = 0;
    /// Curves that method 3 with literal detection trims wrongly if its search ends with
    /// run B.
    std::size_t wrong_to_run_end = 0;
    /// The same if the search ends with the curve, as printed.
    std::size_t wrong_to_curve_end = 0;
};

/// Counts over open curves.
TwistCounts twist_counts(const std::vector<TrimmingTrial>& trials);

/// The depth of the untrimmed curve below its own upper envelope, mm: 0 without
/// interference.
double depth_below_envelope(const SectionCurve& curve);

/// The share of the length in s that method 3 as printed deletes from an open curve.
double path_lost_as_printed(const SectionCurve& curve);

/// The place of a hard profile among `hard_profiles`. \throws DomainError for no profile.
std::size_t hard_profile_number(const std::string& name);

}  // namespace endmill
