// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/fold_scan.h"

#include <algorithm>
#include <cmath>

#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

// The two branches of the first fold: the runs of z before and after its cusps.
std::optional<Branches> first_fold(const SectionChain& chain)
{
    RunReader runs{chain, RunAxis::Z, dead_band(chain.input()), chain.first()};
    const auto a = runs.next();
    if (!a)
        return std::nullopt;
    for (int between = a->grows ? 1 : 2; between > 0; --between)
        runs.next();
    const auto b = runs.next();
    if (!b)
        return std::nullopt;
    return Branches{a->first, a->last, b->first, b->last};
}

}  // namespace

std::vector<FoldToSearch> first_literal_folds(const std::vector<PlaneSection>& sections)
{
    std::vector<FoldToSearch> folds;
    for (const PlaneSection& section : sections)
        for (const SectionCurve& curve : section.curves) {
            SectionChain chain{curve.points, 0};
            if (const auto branches = first_fold(chain))
                folds.push_back({std::move(chain), *branches});
        }
    return folds;
}

double scanned_lines(const FoldToSearch& fold, const std::optional<ChainCrossing>& hit,
                     double step_mm)
{
    const auto& [chain, branches] = fold;
    const SectionPoint& cusp_a = chain.at(branches.cusp_a);
    const SectionPoint& cusp_b = chain.at(branches.cusp_b);
    const auto on_a = first_meeting_of_a(chain, branches, 0, cusp_b.x());
    const auto on_b = first_meeting_of_b(chain, branches, 0, cusp_a.x());
    if (!on_a && !on_b)
        return 0;
    const double end_a = on_a ? on_a->other : chain.at(branches.first_a).y();
    const double end_b = on_b ? on_b->other : chain.at(branches.last_b).y();
    const double high =
        std::min(std::max(end_a, cusp_a.y()), std::max(end_b, cusp_b.y()));
    const double low = std::max(std::min(end_a, cusp_a.y()), std::min(end_b, cusp_b.y()));
    if (hit)
        return std::round((high - hit->at.y()) / step_mm) + 1;
    return high < low ? 0 : std::floor((high - low) / step_mm) + 1;
}

std::vector<std::optional<ChainCrossing>> crossings(
    const std::vector<FoldToSearch>& folds, CrossingSearch* search,
    const TrimmingOptions& options)
{
    std::vector<std::optional<ChainCrossing>> found;
    found.reserve(folds.size());
    for (const FoldToSearch& fold : folds)
        found.push_back(search(fold.chain, fold.branches, options));
    return found;
}

ScanOutcome scan_outcome(const std::vector<FoldToSearch>& folds,
                         const std::vector<std::optional<ChainCrossing>>& truth,
                         const TrimmingOptions& options)
{
    const auto found = crossings(folds, search_by_distance, options);
    ScanOutcome outcome;
    for (std::size_t i = 0; i < folds.size(); ++i) {
        outcome.lines += scanned_lines(folds[i], found[i], options.scan_step);
        if (found[i])
            ++outcome.hits;
        if (found[i] && !truth[i])
            ++outcome.false_hits;
        if (!found[i] && truth[i])
            ++outcome.missed;
        if (found[i] && truth[i])
            outcome.error_mm =
                std::max(outcome.error_mm, (found[i]->at - truth[i]->at).norm());
    }
    outcome.lines /= static_cast<double>(folds.size());
    return outcome;
}

}  // namespace endmill
