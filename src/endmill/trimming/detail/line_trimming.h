// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Method 2, straight lines and subdivision. The line through a segment of A selects the
/// first segment of B that it crosses; the line through that one selects a segment of A,
/// and so on until the segment of A does not change. Then the two segments cross. The
/// iteration converges quadratically on convex branches. On other branches it may find
/// nothing, or stop after 60 rounds without a result.
/// Source: [JangKimJeong, section IV.2].
std::optional<ChainCrossing> search_by_lines(const SectionChain& chain,
                                             const Branches& branches,
                                             const TrimmingOptions& options);

/// Trims the curves of a plane with method 2.
/// \throws DomainError on a curve with fewer than two points or with a point that is not
///     finite.
Trimmed trim_by_lines(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options);

}  // namespace endmill
