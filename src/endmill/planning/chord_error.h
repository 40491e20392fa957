// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// How far a path's chords stray from the lines that they replace.
struct ChordError {
    double greatest_mm;  ///< from a point of the line to the chord
    double pitch_mm;     ///< greatest distance between neighbouring samples
    SurfacePoint at;     ///< where
    int patch = 0;       ///< of a part of several surfaces: on which, from 0
};

/// Measures the cuts of `path`, each at samples of its iso-parametric line that lie
/// 0.25 mm apart on average or less (64 at least, 4096 at most), refined at the worst
/// of them. Passed over are cuts that are certain, by a bound on the line's second
/// derivative, to stray less than one measured before. The true maximum may exceed the
/// result by what a line bends within a pitch, but for the refinement.
/// \param along the parameter along which the passes run.
/// \pre the contacts of a pass share their other parameter.
ChordError chord_error(const Surface& surface, const ToolPath& path, Parameter along);

/// The same for a path over several surfaces.
/// \pre the path's patches are numbers of `surfaces`.
ChordError chord_error(std::span<const Surface> surfaces, const ToolPath& path,
                       Parameter along);

}  // namespace endmill
