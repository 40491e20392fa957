// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Method 3, segments in sequence. For each segment of B, from the cusp outwards, the
/// first segment of A that its line crosses is found. The first pair in which the line of
/// A's segment also crosses B's segment is the crossing. Takes |A| |B| steps if there is
/// no crossing.
/// Source: [JangKimJeong, section IV.3].
std::optional<ChainCrossing> scan_segments(const SectionChain& chain,
                                           const Branches& branches,
                                           const TrimmingOptions& options);

/// The same with the printed range of B: with literal detection B continues to the last
/// vertex of the chain. Takes up to |A| times as many steps as the chain has segments
/// behind B's cusp. With guarded detection, which works on pairs of runs, it is
/// scan_segments.
/// Source: [JangKimJeong, section IV.3].
std::optional<ChainCrossing> scan_to_end(const SectionChain& chain,
                                         const Branches& branches,
                                         const TrimmingOptions& options);

/// Method 3 in |A| + |B| steps, with two pointers. Both branches are followed upwards: in
/// z with literal detection, whose runs are monotone in z, and in s with guarded
/// detection. Segments beside each other are tested. Returns the lowest crossing.
std::optional<ChainCrossing> march_segments(const SectionChain& chain,
                                            const Branches& branches,
                                            const TrimmingOptions& options);

/// march_segments, scan_segments or scan_to_end, as TrimmingOptions::search selects.
std::optional<ChainCrossing> search_in_sequence(const SectionChain& chain,
                                                const Branches& branches,
                                                const TrimmingOptions& options);

/// Trims the curves of a plane with method 3.
/// \throws DomainError on a curve with fewer than two points or with a point that is not
///     finite.
Trimmed trim_in_sequence(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options);

/// Trims the curves of a plane with the repaired method 3. Not only neighbouring runs
/// forward in s are searched for a crossing but all pairs, nearest first. This finds
/// nested loops, and loops with a zigzag at a cusp. Detection is always guarded; no
/// option has an effect.
/// \throws DomainError on a curve with fewer than two points or with a point that is not
///     finite.
Trimmed trim_repaired(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options);

}  // namespace endmill
