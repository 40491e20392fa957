// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/vec.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/surface/surface.h"

/// \file
/// The cells by which a surface is drawn with the painter's algorithm.

namespace endmill {

/// A piece of a surface between neighbouring iso-parametric lines.
struct SurfaceCell {
    /// Chords of a side. They are off the curve by less than the width of a line.
    static constexpr int steps_per_side = 8;
    static constexpr std::size_t points = 4 * steps_per_side;  ///< of the outline

    /// Counter-clockwise in (u, v) from the corner (u low, v low), in mm.
    std::array<Vec3, points> outline;
    /// Whether the sides v low, u high, v high, u low are patch borders.
    std::array<bool, 4> is_border;

    /// The mean of the four corners, by which cells are sorted, in mm.
    Vec3 middle() const
    {
        return (outline[0] + outline[points / 4] + outline[points / 2] +
                outline[3 * points / 4]) /
               4;
    }

    /// The product of both diagonals, on the side from which the outline runs
    /// counter-clockwise, in mm^2.
    Vec3 diagonals_normal() const
    {
        return (outline[points / 2] - outline[0])
            .cross(outline[3 * points / 4] - outline[points / 4]);
    }
};

/// All cells of a surface. \param spaces number of cells along each side of a patch, at
/// least 1.
std::vector<SurfaceCell> surface_cells(const Surface& surface, int spaces);

/// The colour of a flat piece of a surface, as below.
/// \param normal of either side and any length.
std::string shade_of(const Vec3& normal, const AxonometricView& view);

/// The colour of a cell in the notation of SVG: light grey blue, darker the more the cell
/// is inclined to a light beside the viewer.
std::string shade_of(const SurfaceCell& cell, const AxonometricView& view);

}  // namespace endmill
