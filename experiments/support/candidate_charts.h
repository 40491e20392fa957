// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/figures/direction_figures.h"
#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/detail/sector_fit.h"

namespace endmill {

/// Directions that a machine must reach, and the tool axis at zero.
struct DirectionSet {
    Vec3 tool_axis;                ///< unit vector
    std::vector<Vec3> directions;  ///< unit vectors
};

/// Parses a set of directions: azimuths and polar angles, "0:30 100:40", or turns about x
/// and y, "50/30 -20/15", in degrees. The tool axis is +z. \throws DomainError for
/// another text.
DirectionSet direction_set(const std::string& text);

/// Figures 7, 8, 13 (a): the directions by azimuth and polar angle, and a double sector.
std::string sector_chart(const std::string& title, const DirectionSet& set,
                         const SectorCandidate& sector);

/// Figures 10, 13 (b): the directions in the gnomonic projection, up to 80 degrees from
/// the tool axis, and a rectangle.
std::string rectangle_chart(const std::string& title, const DirectionSet& set,
                            const RectangleCandidate& rectangle);

/// Figures 9, 14: the hull of the directions and the tool axis, in the gnomonic or
/// orthographic projection.
std::string hull_chart(const std::string& title, const DirectionSet& set,
                       ChartProjection projection);

}  // namespace endmill
