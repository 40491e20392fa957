// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Method 3, segments in sequence: for each segment of B, from the cusp on, the first of A
/// that its line crosses; the first pair that also crosses the other way is the crossing.
/// Takes |A| |B| steps where there is none.
/// Source: [JangKimJeong, section IV.3].
std::optional<ChainCrossing> scan_segments(const SectionChain& chain,
                                           const Branches& branches,
                                           const TrimmingOptions& options);

/// The same in |A| + |B| steps, by two pointers: both branches are followed upwards in z
/// (literal detection, whose runs are monotone in z) or in s (guarded), and segments that
/// are beside each other are tested. Answers the lowest crossing.
std::optional<ChainCrossing> march_segments(const SectionChain& chain,
                                            const Branches& branches,
                                            const TrimmingOptions& options);

/// One of the two, as TrimmingOptions::search says.
std::optional<ChainCrossing> search_in_sequence(const SectionChain& chain,
                                                const Branches& branches,
                                                const TrimmingOptions& options);

/// Trims the curves of a plane by method 3.
/// \throws DomainError on a curve that is not finite.
Trimmed trim_in_sequence(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options);

}  // namespace endmill
