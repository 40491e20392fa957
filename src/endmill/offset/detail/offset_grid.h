// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// A grid line: its parameter, and the patch from which the surface is evaluated on it.
struct GridLine {
    double parameter;
    int patch;
};

/// A rectangle of grid lines within which a surface has no crease and no gap. A surface
/// with inner creases has several grids.
struct OffsetGrid {
    std::int32_t surface;  ///< number of its surface
    double side;           ///< from tool_side_sign: the normal is side * du x dv
    std::int32_t first;    ///< number of its first vertex
    /// Grid lines u = const, ascending.
    std::vector<GridLine> u;
    /// Grid lines v = const, ascending.
    std::vector<GridLine> v;

    /// Number of lines u = const.
    std::int32_t columns() const { return static_cast<std::int32_t>(u.size()); }
    /// Number of lines v = const.
    std::int32_t rows() const { return static_cast<std::int32_t>(v.size()); }
    /// Number of the vertex on lines i and j.
    std::int32_t vertex(std::int32_t i, std::int32_t j) const
    {
        return first + j * columns() + i;
    }
    /// Columns and rows of the vertices on side `number`, 0 … 3. The sides run
    /// counter-clockwise as seen from the tool; each begins where the previous one ends.
    std::vector<std::array<std::int32_t, 2>> side_places(int number) const;
};

/// Point and partials on lines i and j, evaluated from the patches of the lines.
SurfaceTangents tangents_at(const OffsetGrid& grid, const Surface& surface,
                            std::int32_t i, std::int32_t j);

/// Unit normal on the tool's side on lines i and j. At a collapsed edge it is the limit
/// of the normals inside the patch.
/// \throws GeometryError with the place if there is no normal.
Vec3 normal_at(const OffsetGrid& grid, const Surface& surface, std::int32_t i,
               std::int32_t j, const SurfaceTangents& tangents);

/// The grids of `surfaces`. Each surface has grid_lines by grid_lines equidistant
/// parameters, and lines at the borders of patches where it is not continuously
/// differentiable. A surface is divided at creases and gaps; both grids then contain the
/// dividing line. A crease is a place where the normals differ by more than 1e-6 rad, a
/// gap one where the points differ by more than 1e-9 of the surface's diagonal.
/// \param surfaces the part.
/// \param sides from tool_side_signs, one for each surface.
/// \param grid_lines at least 2.
std::vector<OffsetGrid> offset_grids(std::span<const Surface> surfaces,
                                     std::span<const double> sides, int grid_lines);

}  // namespace endmill
