// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// The reason why a stretch of points was cut out of a section curve.
enum class CutCause : std::uint8_t {
    Fold,    ///< a crossing bounds the stretch
    Crease,  ///< a crossing bounds the stretch, with a contact on a concave crease
    /// No crossing bounds the stretch. It reaches an end of the curve or a vertical step.
    End,
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
    /// The crossing that bounds the stretch. If two crossings bound it, this is the first
    /// one along the curve. Without a crossing it is the new end of the curve, which may
    /// lie inside a segment. The coordinates are those of the result. Empty if nothing of
    /// the curve remains.
    std::optional<SectionPoint> place;
    /// The rule that cut the stretch; if several rules did, the last one:
    ///
    ///     below the envelope  method `envelope`; closed curves, except with `winding`
    ///     winding number      method `winding`: the cutter would be inside the part
    ///     valley              methods 1, 2, 3 (guarded) and 3r: a loop behind a crossing
    ///     E1, E2              the same methods: a tail at the end or at the beginning
    ///     E3                  the same methods: a branch too short to cross the next
    ///     P4, P3              methods 1, 2, 3 (literal): signs - + - + or + - + of dz
    ///     P4 cut, P3 cut      the same methods: these signs, but no crossing found
    ///     closed              methods 1, 2, 3, 3r: a closed curve below the others
    ///     outside the range   all methods: the part ends there
    ///
    /// Empty if the method does not name a rule.
    std::string_view rule;
};

/// Reports whether a vertex of a section belongs to a contact on a concave crease.
using CreaseTest = std::function<bool(SegmentNumber)>;

/// The crease test of a section of an offset mesh: a vertex belongs to a concave crease
/// if an end of the mesh edge that it lies on does.
/// \param offset  the offset. \param section a section of it; its edges are numbers of
///                vertices of `offset`. Both must outlive the test.
CreaseTest crease_test(const OffsetMesh& offset, const PlaneSection& section);

/// Lists the stretches of `curves` that `trimmed` does not contain, ordered by curve and
/// first point. The list depends on the curves and the result alone, so that the lists of
/// different methods are comparable. The two equal ends of a closed curve count as one
/// point.
/// \param curves the section curves of one plane, as they were trimmed.
/// \param trimmed the result of a trimming method for these curves.
/// \param is_on_crease an empty function means that the part has no creases.
std::vector<CutOut> cut_out(std::span<const SectionCurve> curves, const Trimmed& trimmed,
                            const CreaseTest& is_on_crease = {});

}  // namespace endmill
