// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "endmill/drop_cutter/detail/drop_kinks.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// A section of a sampled offset, with the smooth part that it approximates.
struct SampledSection {
    const PlaneSection& section;  ///< section of the offset mesh
    DriveLine line;               ///< its drive plane
    const OffsetMesh& offset;     ///< the sampled offset
    const SmoothDrop& drop;       ///< of the part, for offset.cutter
    /// Called with a number of points that are finished.
    const std::function<void(std::size_t points)>& finish;
};

/// The trimmed curves of one plane after refinement.
struct RefinedCurves {
    std::vector<TrimmedCurve> curves;  ///< in their original order
    /// number of points at which the cutter now rests on the part
    std::size_t refined = 0;
    std::size_t unrefined = 0;  ///< number of points that keep their sampled position
    /// mm, largest change of z of a point; a crossing counts at its old s.
    double greatest_shift = 0;
};

/// Moves every point of the trimmed curves of a plane that lies on the upper envelope of
/// its section to the height at which the cutter rests on the smooth part: over the
/// point's own s, and for a crossing over the s at which two contacts are equally high.
/// Crossings that the sampling missed are inserted. Vertices that a crossing has passed
/// are removed.
///
/// Three kinds of points keep their sampled position: points below the envelope, which a
/// method left in a fold; points on a vertical step or on the vertical rim of the offset,
/// where the height over s is not unique; and points where the cutter touches a border,
/// if the offset has no contacts there.
/// Source: docs/methods/interference.md, section 6.
/// \param sampled the section and the part.
/// \param curves the trimmed curves of the section.
/// \param finer belongs to `sampled.drop` and to this thread alone.
RefinedCurves refined(const SampledSection& sampled,
                      const std::vector<TrimmedCurve>& curves, FinerPieces& finer);

/// The largest change of z in mm that `refined` would make to a point, or `least` if that
/// is larger. It is faster than `refined`: it searches for contacts far from the sampled
/// ones only where the change from the nearest contact exceeds the largest so far.
/// \param sampled the section and the part.
/// \param curves the trimmed curves of the section.
/// \param least mm, a change that is known already.
/// \param finer belongs to `sampled.drop` and to this thread alone.
double greatest_shift(const SampledSection& sampled,
                      const std::vector<TrimmedCurve>& curves, double least,
                      FinerPieces& finer);

}  // namespace endmill
