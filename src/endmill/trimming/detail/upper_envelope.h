// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "endmill/trimming/detail/plane_points.h"
#include "endmill/trimming/detail/section_order.h"

namespace endmill {

/// The carrier over intervals where no curve lies.
inline constexpr std::int32_t no_segment = -2;

/// A piece of an upper envelope with one carrier.
struct EnvelopePiece {
    std::int32_t segment;  ///< the carrier, or no_segment
    /// Where the piece begins: at the s of this vertex if not negative, otherwise at
    /// crossing ~from.
    std::int32_t from;
};

/// The upper envelope of segments as a function of s, from left to right.
struct UpperEnvelope {
    /// Neighbours have different carriers, and no piece has length 0. The first piece may
    /// have no carrier; then it begins at -infinity.
    std::vector<EnvelopePiece> pieces;
    std::int32_t end = 0;  ///< end of the last piece, encoded as EnvelopePiece::from
    /// those that `pieces` refer to, and others
    std::vector<EnvelopeCrossing> crossings;
    /// numbers of the vertical segments, but for some that lie below the envelope
    std::vector<std::int32_t> verticals;
};

/// The upper envelope of all segments that are not vertical. Where segments coincide, the
/// one with the smallest number counts as the carrier.
///
/// Every decision is exact for all finite coordinates; rounded arithmetic decides only
/// within a proved bound (paper/notes/envelope-filters.md). Takes O(n log n) comparisons
/// for n segments, and O(n) for the section of an offset, whose folds are short as a
/// rule: about 15 ns per segment.
///
/// Each chain, a run of segments with the same sign of ds, is merged into the envelope of
/// the chains before it, starting where the last one ended. For this the envelope is
/// stored as two stacks that meet there. A chain over many more pieces than it has
/// segments begins an envelope of its own; such envelopes are merged as the runs of a
/// natural merge sort are.
/// Source: [Hershberger, pages 169 to 174], with the merging of a natural merge sort.
/// \pre the coordinates are finite.
UpperEnvelope upper_envelope(const SectionPoints& section);

}  // namespace endmill
