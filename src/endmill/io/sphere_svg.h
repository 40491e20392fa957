// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "endmill/accessibility/sphere_grid.h"
#include "endmill/accessibility/visibility_map.h"
#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/io/shown_setup.h"

namespace endmill {

/// Cells of a sphere that are filled one by one; of a finer one only the outlines show.
inline constexpr std::size_t most_filled_cells = 100'000;

/// What is drawn on a sphere of directions, and what surrounds it.
struct SphereFigure {
    std::string title = "Directions";      ///< above it; at most 100 characters show
    std::vector<std::string> captions{};   ///< lines below the title; 150 characters show
    double width_px = 900;                 ///< of the whole picture, at least 300
    Angle azimuth = Angle::degrees(-60);   ///< where the viewer stands, from X towards Y
    Angle elevation = Angle::degrees(30);  ///< of the viewer over the XY plane
    std::optional<ShownSetup> setup{};  ///< axes and borders; none: the part's directions
    std::vector<Vec3> marked{};  ///< unit, the part's: discs, such as the paper's MD
};

/// The sphere of directions as an SVG file: the front half of its cells, shaded by how many
/// facets a tool reaches along them; with a setup in the machine's directions at zero,
/// with its axes and the borders of its motion, dashed where they are behind.
/// Source: [KangSuh, figure 12].
/// \throws DomainError unless the map has the grid's cells and at least one facet, or as
///         `motion_borders` and `AxonometricFigure`.
std::string sphere_svg(const SphereGrid& grid, const VisibilityMap& map,
                       const SphereFigure& figure);

}  // namespace endmill
