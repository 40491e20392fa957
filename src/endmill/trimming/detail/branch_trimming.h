// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/branches.h"
#include "endmill/trimming/detail/guarded_folds.h"

namespace endmill {

/// What distinguishes the methods that search for crossings of branches.
struct BranchMethod {
    /// How the method searches two branches for a crossing.
    CrossingSearch* search;
    RunPairs pairs = RunPairs::Neighbours;  ///< with guarded detection
};

/// Trims the curves of a plane. Each open curve is trimmed on its own. A closed curve is
/// dropped if none of its points lies above the upper envelope of the open curves (rule
/// `closed`); otherwise its own upper envelope is kept.
/// \throws DomainError on a curve with fewer than two points or with a point that is not
///     finite.
Trimmed trim_branches(std::span<const SectionCurve> curves, const BranchMethod& method,
                      const TrimmingOptions& options);

}  // namespace endmill
