// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to interference
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "endmill/interference/slicer.h"
#include "endmill/interference/smooth_offset.h"
#include "endmill/interference/trimming.h"

namespace endmill {

/// Trimmed curves of one plane, their points put on the smooth offset.
struct RefinedCurves {
    std::vector<TrimmedCurve> curves;
    std::size_t refined = 0;    ///< points that now lie on the smooth offset
    std::size_t unrefined = 0;  ///< points kept as sampled
    double greatest_shift = 0;  ///< of the refined ones' z, or of a crossing, mm
};

/// The curves that were trimmed, and t of their plane in mm.
struct PlacedSection {
    const PlaneSection& section;
    double across;
};

/// Whether the cutter may stand with its reference point there, `shift` mm from where it
/// was sampled: on no other sheet's wrong side.
using IsAdmissible = std::function<bool(const Vec3& reference, double shift)>;

/// Polishes what is left in a plane by Newton's method: a crossing by its
/// two contacts at once, any other point over its s. A point stays as it is sampled where
/// the search leaves the neighbouring cells or does not converge, over corners of the part
/// and level places of a flat bottom, and where the polished one is not admissible. Points
/// that a crossing has passed by are left out.
/// Source: specification of the interference removal, section 6.
/// \param is_admissible may be empty: all are.
RefinedCurves refined(const std::vector<TrimmedCurve>& curves,
                      const PlacedSection& placed, const DriveFrame& frame,
                      const SmoothOffset& offset, const IsAdmissible& is_admissible);

}  // namespace endmill
