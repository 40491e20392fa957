// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/printed_search.h"

#include "support/timed_trimming.h"

namespace endmill {
namespace {

Trimmed trim_to_end(std::span<const SectionCurve> curves, const TrimmingOptions& options)
{
    TrimmingOptions printed = options;
    printed.search = BranchSearch::ScanToEnd;
    return trimming_method("3").trim(curves, printed);
}

}  // namespace

const TrimmingMethod& printed_method_3()
{
    static constexpr TrimmingMethod method{
        "3 to end", "segments in sequence, to the end of the curve", true, trim_to_end};
    return method;
}

}  // namespace endmill
