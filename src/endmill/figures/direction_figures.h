// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/feasible_directions.h"

/// \file
/// Figures of sets of tool directions: on the sphere, and in charts of the plane. A set
/// is the feasible tool motion of a machine; FeasibleDirections computes its border.
///
/// Implemented in `direction_sphere_svg.cpp` (the sphere) and `direction_charts.cpp` (the
/// charts).

namespace endmill {

/// Projection of directions around a pole to a plane.
enum class ChartProjection {
    Equidistant,  ///< distances from the centre are proportional to polar angles
    Gnomonic,     ///< great circles become straight lines
    Orthographic  ///< the sphere as seen from the pole
};

/// Directions to be shown in a chart.
struct ChartedDirections {
    std::string title;             ///< above the chart
    Vec3 pole;                     ///< unit vector in the centre: the tool axis
    Vec3 right;                    ///< unit vector across the pole: azimuth 0
    std::vector<Vec3> directions;  ///< unit vectors, drawn as discs
    ChartProjection projection = ChartProjection::Equidistant;  ///< of the chart
};

/// A chart of directions and the border of a set that should contain them, as an SVG
/// file. A gnomonic chart reaches at most 80 degrees from the pole and also shows the
/// line towards the first rotary axis.
/// Source: after [KangSuh, figures 7, 8, 10 and 13].
/// \param border_label name of the border in the legend.
std::string motion_chart(const ChartedDirections& chart, const FeasibleDirections& motion,
                         std::string_view border_label);

/// A chart of directions and their hull, as an SVG file, in the gnomonic or orthographic
/// projection.
/// Source: after [KangSuh, figures 9 and 14].
/// \param hull vertices in order, unit vectors.
/// \throws DomainError if `hull` is empty.
std::string hull_chart(const ChartedDirections& chart, std::span<const Vec3> hull);

/// The sphere of directions with a set, as an SVG file. It shows:
/// - the border of the set;
/// - the basis circle, which the tool axis follows if only the tilt (C,A) or only R1
///   (A,B) moves;
/// - the rotary axes that move, and the tool axis at zero;
/// - the names of [KangSuh, figure 5], if both axes are limited.
///
/// Lines behind the sphere are dashed.
/// Source: after [KangSuh, figures 2, 5 and 6].
/// \param legend name of the border in the legend.
std::string direction_sphere_svg(const FeasibleDirections& set, const std::string& title,
                                 const std::string& legend);

}  // namespace endmill
