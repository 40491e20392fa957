// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/branch_trimming.h"

#include <algorithm>
#include <iterator>

#include "endmill/trimming/detail/closed_sections.h"
#include "endmill/trimming/detail/literal_folds.h"
#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

// The point of smallest s, and of smallest z among those. A curve that steps back in s
// may have it anywhere, so that all points are visited.
SectionPoint leftmost(const TrimmedCurve& curve)
{
    SectionPoint least = curve.points.front().at;
    for (const TrimmedPoint& point : curve.points) {
        if (point.at.x() < least.x() ||
            (point.at.x() == least.x() && point.at.y() < least.y()))
            least = point.at;
    }
    return least;
}

void sort_by_place(std::vector<TrimmedCurve>& curves)
{
    if (curves.size() < 2)
        return;
    std::stable_sort(curves.begin(), curves.end(),
                     [](const auto& one, const auto& other) {
                         const SectionPoint a = leftmost(one);
                         const SectionPoint b = leftmost(other);
                         return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
                     });
}

void append_trimmed(SectionChain& chain, double dead_band, const BranchMethod& method,
                    const TrimmingOptions& options, Trimmed& trimmed)
{
    const CrossingFinder find = bound(method.search, options);
    if (options.detection == FoldDetection::Literal)
        trim_literally(chain, dead_band, find, options.patterns);
    else
        trimmed.unresolved += trim_guarded(chain, dead_band, find, method.pairs);
    TrimmedCurve curve = chain.curve();
    if (!curve.points.empty())
        trimmed.curves.push_back(std::move(curve));
    trimmed.rules.insert(trimmed.rules.end(), chain.rules().begin(), chain.rules().end());
}

}  // namespace

Trimmed trim_branches(std::span<const SectionCurve> curves, const BranchMethod& method,
                      const TrimmingOptions& options)
{
    const bool has_closed = std::any_of(
        curves.begin(), curves.end(), [](const auto& curve) { return curve.is_closed; });
    std::vector<double> dead_bands;
    for (const SectionCurve& curve : curves)
        dead_bands.push_back(dead_band(curve.points));

    Trimmed result = has_closed ? trim_closed(curves) : Trimmed{};
    for (std::size_t number = 0; number < curves.size(); ++number) {
        if (curves[number].is_closed)
            continue;
        SectionChain chain{curves[number].points, static_cast<std::int32_t>(number)};
        append_trimmed(chain, dead_bands[number], method, options, result);
    }
    sort_by_place(result.curves);
    return result;
}

}  // namespace endmill
