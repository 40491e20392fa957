// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/offset/slicer.h"
#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// A fold that is searched for a crossing.
struct FoldToSearch {
    SectionChain chain;
    Branches branches;
};

/// The first fold of each curve with one, as literal detection finds it: by the signs of
/// dz from its first point on, - + - + or + - +.
/// \param sections must outlive the result.
std::vector<FoldToSearch> first_literal_folds(const std::vector<PlaneSection>& sections);

/// How many lines method 1 looks at until it answers `hit`, or all there are.
double scanned_lines(const FoldToSearch& fold, const std::optional<ChainCrossing>& hit,
                     double step_mm);

/// What a search finds in each of `folds`.
std::vector<std::optional<ChainCrossing>> crossings(
    const std::vector<FoldToSearch>& folds, CrossingSearch* search,
    const TrimmingOptions& options);

/// How method 1 did on folds whose crossings are known.
struct ScanOutcome {
    int hits = 0;
    int missed = 0;       ///< crossings that are there and not found
    int false_hits = 0;   ///< answers where there is none
    double lines = 0;     ///< scanned a fold, on average
    double error_mm = 0;  ///< largest distance of a hit from the true crossing
};

/// Method 1 on `folds`. \param truth what method 3 finds in them.
ScanOutcome scan_outcome(const std::vector<FoldToSearch>& folds,
                         const std::vector<std::optional<ChainCrossing>>& truth,
                         const TrimmingOptions& options);

}  // namespace endmill
