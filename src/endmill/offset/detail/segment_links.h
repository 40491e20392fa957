// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/offset/slicer.h"

namespace endmill {

/// Which segment of a section goes on where each one ends: one that begins on the same
/// edge, if any. Keeps its room from one section to the next.
class SegmentLinks {
public:
    using Index = std::int32_t;
    static constexpr Index none = -1;

    /// Links the segments from[k] -> to[k]. No segment is linked to two, and none from
    /// two; where an edge begins or ends several, who gets whom hangs on nothing but
    /// their order.
    void link(std::span<const CrossedEdge> from, std::span<const CrossedEdge> to);

    /// The segment that goes on, or `none`.
    Index next(Index segment) const { return next_[segment]; }

    /// Whether `segment` goes on from another.
    bool is_entered(Index segment) const { return is_entered_[segment] != 0; }

private:
    void guess(std::span<const CrossedEdge> from, std::span<const CrossedEdge> to);
    void look_up(std::span<const CrossedEdge> from, std::span<const CrossedEdge> to);
    void join(Index segment, Index next);

    std::vector<Index> next_;
    std::vector<std::uint8_t> is_entered_;
    std::vector<Index> open_;   // segments that are not linked yet
    std::vector<Index> table_;  // of segments, by the edge on which they begin
};

}  // namespace endmill
