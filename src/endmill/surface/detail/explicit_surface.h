// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "endmill/surface/surface.h"

namespace endmill {

/// A height over the xy plane with its first and second partial derivatives.
struct HeightJet {
    double z;    ///< mm
    double zx;   ///< slope along x
    double zy;   ///< slope along y
    double zxx;  ///< 1/mm
    double zxy;  ///< 1/mm
    double zyy;  ///< 1/mm
};

/// A surface z(x, y), all in mm.
using ExplicitSurface = std::function<HeightJet(double x, double y)>;

/// A rectangle of the xy plane, in mm.
struct Rectangle {
    Interval x;
    Interval y;
};

/// The test surface of Park and Maeng, z = 40 g(x / 40, y / 40) with
/// g = a b (a^2 - b^2) / (a^2 + b^2 + 1/4); that one unit is 40 mm is our reading.
/// Source: [ParkMaeng, section 5]; spec of ball-end milling, section 7.
/// Turned by a right angle about z it is the same surface.
HeightJet ball_end_test_surface(double x, double y);

/// A bicycle saddle of our own, for 180 by 40 mm about the origin, convex across and sagging
/// along x:
///
///     z = 10 (x/90)^2 - 3 (sqrt(b^2 + y^2) - b),  b = 8 + 10 s^2 (3 - 2 s),  s = (x/90 + 1)/2,
///
/// narrow (b = 8 mm) at the nose, x = -90, wide at the rear; its flanks steepen towards
/// atan 3 = 71.6 degrees.
HeightJet bicycle_saddle(double x, double y);

/// The surface of a height grid, whose u is x and v is y.
ExplicitSurface explicit_surface(Surface grid);

/// The spline through `surface` at the nodes of `intervals_x` by `intervals_y` equal cells.
/// \throws DomainError unless there is a cell.
Surface gridded(const ExplicitSurface& surface, const Rectangle& extent, int intervals_x,
                int intervals_y);

/// Largest difference in height of two surfaces, in mm, at `steps` by `steps` cells' corners.
double farthest_apart(const ExplicitSurface& one, const ExplicitSurface& other,
                      const Rectangle& extent, int steps);

/// What a surface is like over a rectangle.
struct SurfaceFacts {
    double least_z_mm;
    double greatest_z_mm;
    double area_mm2;
    double steepest_deg;     ///< slope
    double least_radius_mm;  ///< of curvature, convex or concave
    double share_above;      ///< of the rectangle whose height is above a level
};

/// By `steps` by `steps` cells: extremes at their corners, area and share by their middles.
SurfaceFacts surface_facts(const ExplicitSurface& surface, const Rectangle& extent,
                           double level_mm, int steps);

}  // namespace endmill
