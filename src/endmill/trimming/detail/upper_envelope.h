// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "endmill/trimming/detail/plane_points.h"

namespace endmill {

/// Where no curve lies.
inline constexpr std::int32_t no_segment = -2;

/// A stretch of an upper envelope that one segment carries.
struct EnvelopePiece {
    std::int32_t segment;  ///< or no_segment
    /// Where it begins: at the s of this vertex, or at crossing ~from.
    std::int32_t from;
};

/// A proper crossing of two segments of an envelope.
struct EnvelopeCrossing {
    double s;  ///< mm, as z
    double z;
    double error;    ///< bounds the errors of s and of z
    std::int32_t p;  ///< one segment
    std::int32_t q;  ///< the other
};

/// The upper envelope of segments as a function of s, from left to right.
struct UpperEnvelope {
    /// No two neighbours have the same segment, and none has length 0. The first may have no
    /// segment, and then begins at -infinity.
    std::vector<EnvelopePiece> pieces;
    std::int32_t end = 0;  ///< of the last piece, told as EnvelopePiece::from
    std::vector<EnvelopeCrossing> crossings;  ///< those that `pieces` name, and others
    std::vector<std::int32_t> verticals;      ///< the segments that are vertical
};

/// The upper envelope of all segments that are not vertical. Where segments coincide the one
/// with the smallest number carries.
///
/// Every decision is exact for all finite coordinates: rounding answers only within a proved
/// bound (paper/notes/envelope-filters.md). O(n log n) comparisons for n segments, and O(n)
/// for the section of an offset, most of whose folds are short: about 20 ns a segment.
///
/// Each run of segments with one sign of ds, a chain, is merged into the envelope of those
/// before it, from where the last one ended: the envelope is kept as two stacks that meet
/// there. A chain over far more pieces than it has segments itself begins an envelope of its
/// own; these are merged as runs of a merge sort are. Source: after Hershberger, Finding the
/// upper envelope of n line segments in O(n log n) time (1989), and natural merge sort.
/// \pre the coordinates are finite.
UpperEnvelope upper_envelope(const SectionPoints& section);

}  // namespace endmill
