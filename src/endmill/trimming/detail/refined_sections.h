// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/drop_cutter/detail/drop_kinks.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// The curves that were trimmed, where they lie, and what they are a sampling of.
struct SampledSection {
    const PlaneSection& section;  ///< of the offset's mesh
    DriveLine line;
    const OffsetMesh& offset;
    const SmoothDrop& drop;  ///< for offset.cutter
};

/// Trimmed curves of one plane, their points where the cutter rests on the smooth part.
struct RefinedCurves {
    std::vector<TrimmedCurve> curves;
    std::size_t refined = 0;    ///< points at which the cutter now rests on the part
    std::size_t unrefined = 0;  ///< points kept as sampled
    double greatest_shift =
        0;  ///< mm in z of a point, or of a crossing over its old place
};

/// Lets the cutter down on the smooth part at every point that is left in a plane and
/// that lies on the upper envelope of its section: over its own s, a crossing where two
/// contacts are equally high. A crossing that was not sampled is put in. Vertices that a
/// crossing has passed by are left out.
///
/// Kept as sampled are points below the envelope, which a method left in a fold; points on
/// a vertical step and on the upright rim of the offset, where the height over s is
/// anything; and those where the cutter touches a border, if the offset has none.
/// Source: specification of the interference removal, section 6.
/// \param finer of this drop and this thread alone.
RefinedCurves refined(const SampledSection& sampled,
                      const std::vector<TrimmedCurve>& curves, FinerPieces& finer);

/// The greatest shift in z of the points that `refined` would move, mm, if above `least`;
/// else `least`. Quicker: contacts far from those sampled are looked for where the shift is
/// greater only.
double greatest_shift(const SampledSection& sampled,
                      const std::vector<TrimmedCurve>& curves, double least,
                      FinerPieces& finer);

}  // namespace endmill
