// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "endmill/trimming/detail/section_chain.h"

namespace endmill {

/// Two branches of a chain between which a loop may lie, as vertex numbers. Branch A
/// leads to its cusp. Branch B starts at its own cusp, behind A.
struct Branches {
    std::int32_t first_a;  ///< start of A
    std::int32_t cusp_a;   ///< end of A
    std::int32_t cusp_b;   ///< start of B
    std::int32_t last_b;   ///< end of B
};

/// Searches two branches for a crossing. With guarded detection only crossings of valley
/// type are accepted. Returns nothing if there is none, or if the method does not find
/// it.
using CrossingSearch = std::optional<ChainCrossing>(const SectionChain& chain,
                                                    const Branches& branches,
                                                    const TrimmingOptions& options);

/// A search bound to its options.
using CrossingFinder =
    std::function<std::optional<ChainCrossing>(const SectionChain&, const Branches&)>;

/// Binds `options` to `search`. \pre the options outlive the result.
CrossingFinder bound(CrossingSearch* search, const TrimmingOptions& options);

/// The crossings of two branches that a search accepts.
enum class CrossingType : std::uint8_t {
    Any,
    Valley  ///< only those at which the path turns left, upwards
};

/// The crossings that a search accepts with `detection`.
CrossingType crossing_type(FoldDetection detection);

/// The crossing of segment `a` of branch A with segment `b` of branch B, each given by
/// its first vertex. Two segments cross if the ends of each lie on different sides of the
/// other's line. A point on the line counts as right of it, which decides segments that
/// touch. Parallel segments do not cross. The sides are exact; the coordinates of the
/// crossing are rounded.
std::optional<ChainCrossing> crossing_of(const SectionChain& chain, std::int32_t a,
                                         std::int32_t b, CrossingType type);

/// The first segment of A, from the cusp outwards, whose ends lie on different sides of
/// the line through segment `line`.
/// \param line first vertex of the segment.
/// \return first vertex of the segment found.
std::optional<std::int32_t> first_crossed_of_a(const SectionChain& chain,
                                               const Branches& branches,
                                               std::int32_t line);

/// The same for branch B.
std::optional<std::int32_t> first_crossed_of_b(const SectionChain& chain,
                                               const Branches& branches,
                                               std::int32_t line);

/// A segment of a branch that meets a line on which one coordinate is constant.
struct BranchMeeting {
    /// First vertex of the segment.
    std::int32_t segment;
    double other;  ///< mm, the other coordinate of the meeting point
};

/// The first segment of A, from the cusp outwards, that meets the line on which
/// coordinate `axis` (0 for s, 1 for z) equals `value`: one end of the segment is above
/// `value`, the other is not.
std::optional<BranchMeeting> first_meeting_of_a(const SectionChain& chain,
                                                const Branches& branches, int axis,
                                                double value);

/// The same for branch B.
std::optional<BranchMeeting> first_meeting_of_b(const SectionChain& chain,
                                                const Branches& branches, int axis,
                                                double value);

}  // namespace endmill
