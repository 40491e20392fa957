// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// Trims the curves of every plane by `method`, on all threads, and cuts what is left off
/// at the ends of its plane's range of s, see clipped_sections.h; of a plane without a
/// range nothing is left. What lies outside is cut out by the rule `outside the range`, and
/// of folds that the method left those count as unresolved that are still there.
/// \param ranges one a plane, as path_ranges gives them; empty: nothing is cut off.
/// \return one a plane.
/// \throws DomainError as the method does, and if ranges are too few or too many.
std::vector<Trimmed> trim_planes(std::span<const PlaneSection> planes,
                                 std::span<const std::optional<Interval>> ranges,
                                 const TrimmingMethod& method,
                                 const TrimmingOptions& options);

}  // namespace endmill
