// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Method 1, by the distance of two points: lines of constant z go down from the highest
/// that both branches can meet, TrimmingOptions::scan_step apart. On the first one on which
/// the branches are nearer than scan_threshold the crossing is taken to be half-way.
///
/// With g = ds/dz of the two segments it is surely found if
/// scan_step |g_B - g_A| <= 2 scan_threshold, and then lies within
/// scan_threshold / |g_B - g_A| of the true one in z. It may answer where there is none.
/// Source: [JangKimJeong, section IV.1].
/// \pre step and threshold are positive and finite.
/// \throws LimitError for more than a hundred million lines.
std::optional<ChainCrossing> search_by_distance(const SectionChain& chain,
                                                const Branches& branches,
                                                const TrimmingOptions& options);

/// Trims the curves of a plane by method 1.
/// \throws DomainError unless step and threshold are positive and finite, and on a curve that
///         is not; LimitError as above.
Trimmed trim_by_distance(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options);

}  // namespace endmill
