// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A straight cutting move. The axis is fixed, so the ball centre moves parallel to the
/// tip. There may be millions of them, so a number of a point takes 32 bits.
struct CutMove {
    std::uint32_t point;  ///< index in the path of the move's end point
    int pass;             ///< number of the pass
    Vec3 from;            ///< mm, tip at the start
    Vec3 to;              ///< mm, tip at the end
    double begin_mm;      ///< mm, length of the path up to `from`
    double length_mm;     ///< mm, above 0

    Vec3 middle() const { return (from + to) / 2; }                ///< mm, tip
    Vec3 direction() const { return (to - from) / length_mm; }     ///< unit vector
    double middle_mm() const { return begin_mm + length_mm / 2; }  ///< mm, as begin_mm
};

/// The moves to the cut points of `path`, in order. Moves of length 0 and vertical moves
/// are left out, because the model does not describe them.
/// \throws GeometryError unless the axis of every point is +z.
std::vector<CutMove> cut_moves(const ToolPath& path);

/// Number of moves of length 0 to cut points.
std::size_t zero_length_cuts(const ToolPath& path);

}  // namespace endmill
