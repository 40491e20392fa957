// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/offset/slicer.h"
#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// A fold of a section curve and the two branches between which a crossing is searched.
struct FoldToSearch {
    SectionChain chain;
    Branches branches;
};

/// The first fold of each curve that has one, by literal detection: the signs of dz from
/// the first point of the curve are - + - + or + - +.
/// \param sections must outlive the result.
std::vector<FoldToSearch> first_literal_folds(const std::vector<PlaneSection>& sections);

/// Number of scan lines that method 1 examines in `fold` until it returns `hit`; without
/// a hit all lines between the ends of the branches. \param step_mm distance of the scan
/// lines.
double scanned_lines(const FoldToSearch& fold, const std::optional<ChainCrossing>& hit,
                     double step_mm);

/// The crossing that `search` finds in each of `folds`.
std::vector<std::optional<ChainCrossing>> crossings(
    const std::vector<FoldToSearch>& folds, CrossingSearch* search,
    const TrimmingOptions& options);

/// Results of method 1 on folds with known crossings.
struct ScanOutcome {
    int hits = 0;
    int missed = 0;       ///< crossings not found
    int false_hits = 0;   ///< crossings reported where there is none
    double lines = 0;     ///< mean number of scan lines a fold
    double error_mm = 0;  ///< largest distance of a hit from the true crossing
};

/// Runs method 1 on `folds`. \param truth the true crossing of each fold, as method 3
/// finds it.
ScanOutcome scan_outcome(const std::vector<FoldToSearch>& folds,
                         const std::vector<std::optional<ChainCrossing>>& truth,
                         const TrimmingOptions& options);

}  // namespace endmill
