// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A straight move in the material. With a fixed axis the ball's centre goes as the tip.
struct CutMove {
    std::size_t point;  ///< to which it leads, in the path
    int pass;
    Vec3 from;         ///< tip, mm
    Vec3 to;           ///< tip, mm
    double begin_mm;   ///< length of the whole path up to `from`
    double length_mm;  ///< above 0

    Vec3 middle() const { return (from + to) / 2; }                ///< tip, mm
    Vec3 direction() const { return (to - from) / length_mm; }     ///< unit
    double middle_mm() const { return begin_mm + length_mm / 2; }  ///< as begin_mm
};

/// The moves of `path` to its cut points, in order, without those that go nowhere and
/// those straight up or down, which are none of the model.
/// \throws GeometryError unless the axis of every point is +z.
std::vector<CutMove> cut_moves(const ToolPath& path);

/// How many moves to cut points go nowhere.
std::size_t zero_length_cuts(const ToolPath& path);

}  // namespace endmill
