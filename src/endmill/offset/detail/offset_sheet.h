// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// A grid line of a surface: where it is, and the patch that it is taken from.
struct SheetLine {
    double parameter;
    int patch;
};

/// A rectangle of grid lines within which a surface has no crease and no gap.
struct OffsetSheet {
    std::int32_t surface;  ///< its number
    double side;           ///< from tool_side_sign: the normal is side * du x dv
    std::int32_t first;    ///< number of its first vertex
    std::vector<SheetLine> u;
    std::vector<SheetLine> v;

    std::int32_t columns() const { return static_cast<std::int32_t>(u.size()); }
    std::int32_t rows() const { return static_cast<std::int32_t>(v.size()); }
    /// Number of the vertex on lines i and j.
    std::int32_t vertex(std::int32_t i, std::int32_t j) const
    {
        return first + j * columns() + i;
    }
    /// Columns and rows of the vertices on side 0 … 3, counter-clockwise seen from the
    /// tool; each side begins where the one before ends.
    std::vector<std::array<std::int32_t, 2>> side_places(int number) const;
};

/// Point and partials on lines i and j, those of the sheet's own patches.
SurfaceTangents tangents_at(const OffsetSheet& sheet, const Surface& surface,
                            std::int32_t i, std::int32_t j);

/// Unit normal on the tool's side there; at a collapsed edge its limit.
/// \throws GeometryError with the place where there is none.
Vec3 normal_at(const OffsetSheet& sheet, const Surface& surface, std::int32_t i,
               std::int32_t j, const SurfaceTangents& tangents);

/// The sheets of `surfaces` on grid_lines by grid_lines evenly spread parameters of each,
/// and the breaks at which it is not continuously differentiable; parted at creases and
/// gaps, whose line both sheets have. A crease is where normals are more than 1e-6 rad
/// apart, a gap where points are by 1e-9 of the surface's diagonal.
/// \param sides from tool_side_signs.
/// \pre grid_lines >= 2
std::vector<OffsetSheet> offset_sheets(std::span<const Surface> surfaces,
                                       std::span<const double> sides, int grid_lines);

}  // namespace endmill
