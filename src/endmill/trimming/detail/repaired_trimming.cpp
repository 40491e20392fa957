// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/repaired_trimming.h"

#include "endmill/trimming/detail/branch_trimming.h"
#include "endmill/trimming/detail/sequence_trimming.h"

namespace endmill {

Trimmed trim_repaired(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options)
{
    TrimmingOptions guarded = options;
    guarded.detection = FoldDetection::Guarded;
    return trim_branches(curves, {march_segments, RunPairs::All}, guarded);
}

}  // namespace endmill
