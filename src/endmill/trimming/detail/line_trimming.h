// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Method 2, by straight lines and subdivision: the line of a segment of A picks one of B,
/// whose line picks one of A, and so on until it is the same again. Then the two cross.
/// On convex branches it converges quadratically; on others it may find nothing, by itself
/// or after 60 rounds.
/// Source: [JangKimJeong, section IV.2].
std::optional<ChainCrossing> search_by_lines(const SectionChain& chain,
                                             const Branches& branches,
                                             const TrimmingOptions& options);

/// Trims the curves of a plane by method 2.
/// \throws DomainError on a curve that is not finite.
Trimmed trim_by_lines(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options);

}  // namespace endmill
