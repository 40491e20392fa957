// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/offset/section_curve.h"

namespace endmill {

/// The successor of each segment of a section: a segment that begins on the edge on which
/// it ends. Keeps its buffers from one section to the next.
class SegmentLinks {
public:
    using Index = std::int32_t;
    /// No segment.
    static constexpr Index none = -1;

    /// Links the segments from[k] -> to[k]. Every segment gets at most one successor and
    /// at most one predecessor. Where several segments end or begin on one edge, their
    /// order alone decides.
    void link(std::span<const CrossedEdge> from, std::span<const CrossedEdge> to);

    /// The successor of `segment`, or `none`.
    Index next(Index segment) const { return next_[segment]; }

    /// Whether `segment` has a predecessor.
    bool is_entered(Index segment) const { return is_entered_[segment] != 0; }

private:
    void guess(std::span<const CrossedEdge> from, std::span<const CrossedEdge> to);
    void look_up(std::span<const CrossedEdge> from, std::span<const CrossedEdge> to);
    void join(Index segment, Index next);

    std::vector<Index> next_;
    std::vector<std::uint8_t> is_entered_;
    std::vector<Index> open_;   // segments without a successor so far
    std::vector<Index> table_;  // hash table of segments by the edge on which they begin
};

}  // namespace endmill
