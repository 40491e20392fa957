// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Why a stretch of points was cut out of a section curve.
enum class CutCause : std::uint8_t {
    Fold,    ///< a crossing bounds the stretch
    Crease,  ///< a crossing bounds it, and one of its contacts is on a concave crease
    End,  ///< no crossing bounds it: it ends at an end of the curve or at a vertical step
    Closed  ///< the stretch is a whole closed curve
};

/// The word that files use for `cause`: `fold`, `crease`, `end` or `closed`.
std::string_view name(CutCause cause);

/// A maximal stretch of consecutive points of a section curve that a trimmed result does
/// not contain.
struct CutOut {
    std::int32_t curve;        ///< number of the section curve
    std::int32_t first_point;  ///< number of its first point
    std::int32_t last_point;   ///< number of its last point
    CutCause cause;            ///< why it was cut out
    /// The crossing that bounds the stretch; if two crossings do, the first one along the
    /// curve. Without a crossing, the new end of the curve, which may lie inside a
    /// segment. The point has the coordinates that it has in the result. Empty if nothing
    /// of the curve remains.
    std::optional<SectionPoint> place;
    /// The rule that cut the stretch; if several rules did, the last one:
    ///
    ///     below the envelope  method `envelope`; closed curves with all methods but `winding`
    ///     winding number      method `winding`: the tool would be in the material there
    ///     valley              methods 1, 2, 3 (guarded) and 3r: a loop behind a crossing
    ///     E1, E2              the same methods: a tail at the end or at the beginning
    ///     E3                  the same methods: a branch too short to cross its neighbour
    ///     P4, P3              methods 1, 2, 3 (literal): the signs - + - + or + - + of dz
    ///     P4 cut, P3 cut      the same methods: the signs without a crossing, a blind cut
    ///     closed              methods 1, 2, 3, 3r: a closed curve below the others
    ///     outside the range   all methods: the part ends there
    ///
    /// Empty if the method does not name a rule.
    std::string_view rule;
};

/// Reports whether a vertex of a section belongs to a contact on a concave crease.
using CreaseTest = std::function<bool(SegmentNumber)>;

/// Lists the stretches of `curves` that `trimmed` does not contain, ordered by curve and
/// first point. The list follows from the curves and the result alone, so that it is
/// comparable between methods. The two equal ends of a closed curve count as one point.
/// \param curves the section curves of one plane, as they were trimmed.
/// \param trimmed the result of a trimming method for these curves.
/// \param is_on_crease an empty function means that the part has no creases.
std::vector<CutOut> cut_out(std::span<const SectionCurve> curves, const Trimmed& trimmed,
                            const CreaseTest& is_on_crease = {});

}  // namespace endmill
