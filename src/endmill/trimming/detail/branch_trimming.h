// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/branches.h"
#include "endmill/trimming/detail/guarded_folds.h"

namespace endmill {

/// How the methods go about a plane that look for crossings of branches.
struct BranchMethod {
    CrossingSearch* search;
    RunPairs pairs = RunPairs::Neighbours;  ///< with guarded detection
};

/// Trims the curves of a plane: each open one by itself. A closed one is dropped if none of
/// its points lies above the upper envelope of the open ones (rule `closed`); else its own
/// upper envelope is kept.
/// \throws DomainError on a curve of fewer than two points or one that is not finite.
Trimmed trim_branches(std::span<const SectionCurve> curves, const BranchMethod& method,
                      const TrimmingOptions& options);

}  // namespace endmill
