// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/section_chain.h"

namespace endmill {

/// Two branches of a chain that cross if there is a loop between them, by vertices: A leads
/// to its cusp, and behind it B away from its own.
struct Branches {
    std::int32_t first_a;
    std::int32_t cusp_a;
    std::int32_t cusp_b;
    std::int32_t last_b;
};

/// Finds where two branches cross, or nothing. With guarded detection only crossings of
/// valley type count: those at which the path turns to the left, upwards.
using CrossingSearch = std::optional<ChainCrossing>(const SectionChain& chain,
                                                    const Branches& branches,
                                                    const TrimmingOptions& options);

/// Where segment `a` of A and `b` of B, told by their first vertices, cross, each having
/// its ends on different sides of the other's line. A point on the line counts as right of
/// it; so does not decide what touches, nor what is parallel. The sides are exact.
std::optional<ChainCrossing> crossing_of(const SectionChain& chain, std::int32_t a,
                                         std::int32_t b, bool valley_only);

/// The first segment of A, from the cusp outwards, whose ends lie on different sides of
/// the line of the segment `line`, told by its first vertex.
std::optional<std::int32_t> first_crossed_of_a(const SectionChain& chain,
                                               const Branches& branches,
                                               std::int32_t line);

/// The same of B.
std::optional<std::int32_t> first_crossed_of_b(const SectionChain& chain,
                                               const Branches& branches,
                                               std::int32_t line);

/// A segment of a branch, by its first vertex, and the other coordinate where it meets the
/// line on which one is constant.
struct BranchMeeting {
    std::int32_t segment;
    double other;  ///< mm
};

/// The first segment of A, from the cusp outwards, that meets the line on which the
/// coordinate `axis` (0 for s, 1 for z) is `value`: one end is above, the other is not.
std::optional<BranchMeeting> first_meeting_of_a(const SectionChain& chain,
                                                const Branches& branches, int axis,
                                                double value);

/// The same of B.
std::optional<BranchMeeting> first_meeting_of_b(const SectionChain& chain,
                                                const Branches& branches, int axis,
                                                double value);

}  // namespace endmill
