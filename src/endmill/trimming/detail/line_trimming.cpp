// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/line_trimming.h"

#include "endmill/trimming/detail/branch_trimming.h"

namespace endmill {

std::optional<ChainCrossing> search_by_lines(const SectionChain& chain,
                                             const Branches& branches,
                                             const TrimmingOptions& options)
{
    constexpr int most_rounds =
        60;  // 1.8 rounds on average where the iteration converges; later it cycles
    // Each branch must meet the line of constant s through the other's cusp; otherwise
    // there is no loop. The segment of A on that line is the start of the iteration.
    const auto start =
        first_meeting_of_a(chain, branches, 0, chain.at(branches.cusp_b).x());
    if (!start || !first_meeting_of_b(chain, branches, 0, chain.at(branches.cusp_a).x()))
        return std::nullopt;

    const CrossingType type = crossing_type(options.detection);
    std::int32_t on_a = start->segment;
    // The line of a segment of A selects a segment of B, whose line selects a segment of
    // A. At a fixed point each segment crosses the line of the other, so that the two
    // segments cross.
    for (int round = 0; round < most_rounds; ++round) {
        const auto on_b = first_crossed_of_b(chain, branches, on_a);
        if (!on_b)
            return std::nullopt;
        const auto next_on_a = first_crossed_of_a(chain, branches, *on_b);
        if (!next_on_a)
            return std::nullopt;
        if (*next_on_a == on_a)
            return crossing_of(chain, on_a, *on_b, type);
        on_a = *next_on_a;
    }
    return std::nullopt;
}

Trimmed trim_by_lines(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options)
{
    return trim_branches(curves, {search_by_lines}, options);
}

}  // namespace endmill
