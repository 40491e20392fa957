// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Method 1, distance of two points. Scan lines of constant z go down from the largest
/// height that both branches reach, scan_step apart. On the first line on which the
/// points of the two branches are nearer than scan_threshold, the crossing is taken to be
/// halfway between them.
///
/// Let g = ds/dz of the two crossing segments. The method is certain to find the crossing
/// if scan_step |g_B - g_A| <= 2 scan_threshold. Its error in z is then at most
/// scan_threshold / |g_B - g_A|. It may also report a crossing where there is none.
/// Source: [JangKimJeong, section IV.1]; the bounds: docs/methods/interference.md,
/// section 5.1.
/// \pre step and threshold are positive and finite.
/// \throws LimitError for more than a hundred million lines.
std::optional<ChainCrossing> search_by_distance(const SectionChain& chain,
                                                const Branches& branches,
                                                const TrimmingOptions& options);

/// Trims the curves of a plane with method 1.
/// \throws DomainError unless step and threshold are positive and finite; on a curve with
///     a point that is not finite.
/// \throws LimitError for more than a hundred million scan lines in a fold.
Trimmed trim_by_distance(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options);

}  // namespace endmill
