// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "endmill/interference/trimming.h"

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
    /// curve ends now. Nothing where nothing of the curve is left.
    std::optional<SectionPoint> place;
    std::string_view
        rule;  ///< the one that cut it, of several the last; empty if not told
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
