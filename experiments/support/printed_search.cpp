// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/printed_search.h"

#include "endmill/trimming/detail/branch_trimming.h"
#include "endmill/trimming/detail/sequence_trimming.h"

namespace endmill {
namespace {

std::optional<ChainCrossing> scan_to_end(const SectionChain& chain,
                                         const Branches& branches,
                                         const TrimmingOptions& options)
{
    Branches printed = branches;
    printed.last_b = chain.last();
    return scan_segments(chain, printed, options);
}

Trimmed trim_to_end(std::span<const SectionCurve> curves, const TrimmingOptions& options)
{
    return trim_branches(curves, {scan_to_end}, options);
}

}  // namespace

const TrimmingMethod& printed_method_3()
{
    static constexpr TrimmingMethod method{
        "3 to end", "segments in sequence, to the end of the curve", true, trim_to_end};
    return method;
}

}  // namespace endmill
