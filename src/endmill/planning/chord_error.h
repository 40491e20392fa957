// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// How far a path's chords stray from the lines that they replace.
struct ChordError {
    double greatest_mm;  ///< from a point of the line to the chord
    double pitch_mm;     ///< greatest distance between neighbouring samples
    SurfacePoint at;     ///< where
};

/// Measures every cut of `path` at 16 samples of its iso-parametric line, refined at the
/// worst of them. The true maximum may exceed it by what the line bends within a pitch.
/// \param along the parameter along which the passes run.
/// \pre the contacts of a pass share their other parameter.
ChordError chord_error(const Surface& surface, const ToolPath& path, Parameter along);

}  // namespace endmill
