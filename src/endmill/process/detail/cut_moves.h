// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A straight cutting move. The axis is fixed, so the ball centre moves parallel to the
/// tip. There may be millions of them, so the ends are those in the path, and a number of a
/// point takes 32 bits.
struct CutMove {
    const PathPoint* end;  ///< the move's end point in the path, which has one before
    std::uint32_t point;   ///< index in the path of the end point
    double begin_mm;       ///< mm, length of the path up to `from`
    double length_mm;      ///< mm, above 0

    const Vec3& from() const
    {
        return (end - 1)->location.tip;
    }                                                     ///< mm, tip at the start
    const Vec3& to() const { return end->location.tip; }  ///< mm, tip at the end
    int pass() const { return end->pass; }                ///< number of the pass
    Vec3 middle() const { return (from() + to()) / 2; }   ///< mm, tip
    Vec3 direction() const { return (to() - from()) / length_mm; }  ///< unit vector
    double middle_mm() const { return begin_mm + length_mm / 2; }   ///< mm, as begin_mm
};

/// The moves to the cut points of `path`, in order. Moves of length 0 and vertical moves
/// are left out, because the model does not describe them.
/// \param path must outlive the moves; its points must stay where they are.
/// \throws GeometryError unless the axis of every point is +z.
std::vector<CutMove> cut_moves(const ToolPath& path);

/// Number of moves of length 0 to cut points.
std::size_t zero_length_cuts(const ToolPath& path);

}  // namespace endmill
