// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Why a stretch was cut out of a section.
enum class CutCause : std::uint8_t {
    Fold,    ///< it is bounded by a crossing
    Crease,  ///< so it is, and a point of it belongs to a contact on a concave crease
    End,     ///< there is no crossing: an end of the curve, or a vertical step
    Closed   ///< a whole closed curve
};

/// As in files: `fold`, `crease`, `end` or `closed`.
std::string_view name(CutCause cause);

/// A maximal stretch of consecutive points of a section curve that a result does not hold.
struct CutOut {
    std::int32_t curve;
    std::int32_t first_point;
    std::int32_t last_point;
    CutCause cause;
    /// The crossing that bounds it, the first one along the curve if two do; or where the
    /// curve ends now, also cut off within a segment: a point of the result, as it is there.
    /// Nothing where nothing of the curve is left.
    std::optional<SectionPoint> place;
    /// The rule that cut it, of several the last:
    ///
    ///     below the envelope  `envelope`; in all but `winding` of closed curves
    ///     winding number      `winding`: the tool would be in the material there
    ///     valley              3r and guarded 1, 2, 3: behind a crossing of two branches
    ///     E1, E2              the same: a tail at the end, at the beginning
    ///     E3                  the same: a branch too short to cross the one beside it
    ///     P4, P3              literal 1, 2, 3: the signs - + - + or + - + of dz
    ///     P4 cut, P3 cut      the same, and no crossing was found: a blind cut
    ///     closed              1, 2, 3, 3r: a closed curve below the others
    ///     outside the range   the part ends there; by any method
    ///
    /// Empty if a method does not tell.
    std::string_view rule;
};

/// Tells whether a point of a section belongs to a contact on a concave crease.
using CreaseTest = std::function<bool(SegmentNumber)>;

/// What `trimmed` does not hold of `curves`, by curve and first point: a record of what was
/// cut out that does not depend on the method. The two equal ends of a closed curve count
/// as one point.
/// \param is_on_crease may be empty: there are no creases.
std::vector<CutOut> cut_out(std::span<const SectionCurve> curves, const Trimmed& trimmed,
                            const CreaseTest& is_on_crease = {});

}  // namespace endmill
