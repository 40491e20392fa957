// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/distance_trimming.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"
#include "endmill/core/orientation.h"
#include "endmill/surface/surface_jet.h"
#include "endmill/trimming/detail/branch_trimming.h"

namespace endmill {
namespace {

Interval between(double one, double other)
{
    return {std::min(one, other), std::max(one, other)};
}

// The interval of heights in mm that the scan lines run over: those that both branches
// reach. A branch counts from its cusp to where it meets the line of constant s through
// the other cusp, or to its end. Nothing if neither branch meets that line: then they do
// not cross.
std::optional<Interval> heights_to_scan(const SectionChain& chain,
                                        const Branches& branches)
{
    const SectionPoint& cusp_a = chain.at(branches.cusp_a);
    const SectionPoint& cusp_b = chain.at(branches.cusp_b);
    const auto on_a = first_meeting_of_a(chain, branches, 0, cusp_b.x());
    const auto on_b = first_meeting_of_b(chain, branches, 0, cusp_a.x());
    if (!on_a && !on_b)
        return std::nullopt;
    const double end_a = on_a ? on_a->other : chain.at(branches.first_a).y();
    const double end_b = on_b ? on_b->other : chain.at(branches.last_b).y();
    const Interval a = between(end_a, cusp_a.y());
    const Interval b = between(cusp_b.y(), end_b);
    return Interval{std::max(a.low, b.low), std::min(a.high, b.high)};
}

void check_lines(const TrimmingOptions& options)
{
    require(options.scan_step > 0 && std::isfinite(options.scan_step),
            "method 1: the step must be positive");
    require(options.scan_threshold > 0 && std::isfinite(options.scan_threshold),
            "method 1: the threshold must be positive");
}

void check_count(const Interval& heights, const TrimmingOptions& options)
{
    constexpr double most_lines = 1e8;  // seconds to minutes for a fold of a few points
    if (!(heights.high - heights.low <= most_lines * options.scan_step))
        throw LimitError{"method 1: over a hundred million lines; take a larger step"};
}

bool is_valley(const SectionChain& chain, std::int32_t a, std::int32_t b)
{
    return turn(chain.at(a), chain.at(chain.next(a)), chain.at(b),
                chain.at(chain.next(b))) > 0;
}

}  // namespace

std::optional<ChainCrossing> search_by_distance(const SectionChain& chain,
                                                const Branches& branches,
                                                const TrimmingOptions& options)
{
    const auto heights = heights_to_scan(chain, branches);
    if (!heights)
        return std::nullopt;
    check_count(*heights, options);
    const CrossingType type = crossing_type(options.detection);
    for (int line = 0;; ++line) {
        const double z = heights->high - line * options.scan_step;
        if (z < heights->low)
            return std::nullopt;
        const auto a = first_meeting_of_a(chain, branches, 1, z);
        if (!a)
            continue;
        const auto b = first_meeting_of_b(chain, branches, 1, z);
        if (!b || !(std::abs(b->other - a->other) < options.scan_threshold))
            continue;
        if (type == CrossingType::Valley && !is_valley(chain, a->segment, b->segment))
            continue;
        const SectionPoint middle{a->other + (b->other - a->other) / 2, z};
        return ChainCrossing{a->segment, b->segment, middle, false};
    }
}

Trimmed trim_by_distance(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options)
{
    check_lines(options);
    return trim_branches(curves, {search_by_distance}, options);
}

}  // namespace endmill
