// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "endmill/surface/surface.h"

namespace endmill {

/// Height over the xy plane with its first and second partial derivatives.
struct HeightJet {
    double z;    ///< mm
    double zx;   ///< slope along x
    double zy;   ///< slope along y
    double zxx;  ///< 1/mm
    double zxy;  ///< 1/mm
    double zyy;  ///< 1/mm
};

/// A surface z = z(x, y); all lengths in mm.
using ExplicitSurface = std::function<HeightJet(double x, double y)>;

/// A rectangle of the xy plane, in mm.
struct XyRectangle {
    Interval x;
    Interval y;
};

/// The test surface of Park and Maeng, z = 40 g(x / 40, y / 40) with g(a, b) = a b (a^2 -
/// b^2) / (a^2 + b^2 + 1/4). The paper does not print the unit; 40 mm is our choice. The
/// surface has a four-fold symmetry of rotation about z.
/// Source: [ParkMaeng, section 5]; docs/methods/ball-end-milling.md, section 7.
HeightJet ball_end_test_surface(double x, double y);

/// A bicycle saddle, defined by this project because the paper does not print its own. It
/// is meant for 180 by 40 mm about the origin, is convex across and concave along x:
///
///     z = 10 (x/90)^2 - 3 (sqrt(b^2 + y^2) - b)
///     with b = 8 + 10 s^2 (3 - 2 s), s = (x/90 + 1)/2.
///
/// It is narrow (b = 8 mm) at the nose, x = -90, and wide (b = 18 mm) at the rear. The
/// slope of its flanks approaches atan 3 = 71.6 degrees.
HeightJet bicycle_saddle(double x, double y);

/// The surface of a height grid. \pre u is x and v is y, as in `height_grid`.
ExplicitSurface explicit_surface(Surface grid);

/// The spline that interpolates `surface` at the nodes of `intervals_x` by `intervals_y`
/// equal cells.
/// \throws DomainError unless both numbers are positive.
Surface gridded(const ExplicitSurface& surface, const XyRectangle& extent,
                int intervals_x, int intervals_y);

/// Largest difference in height of two surfaces in mm, at the corners of `steps` by
/// `steps` cells.
double farthest_apart(const ExplicitSurface& one, const ExplicitSurface& other,
                      const XyRectangle& extent, int steps);

/// Measures of a surface over a rectangle.
struct SurfaceFacts {
    double least_z_mm;
    double greatest_z_mm;
    double area_mm2;
    double steepest_deg;  ///< largest slope
    /// Smallest radius of principal curvature, convex or concave.
    double least_radius_mm;
    double share_above;  ///< share of the rectangle with a height above the level
};

/// Measures over `steps` by `steps` cells: extremes at their corners, area and share at
/// their middles. \param level_mm the level of `share_above`.
SurfaceFacts surface_facts(const ExplicitSurface& surface, const XyRectangle& extent,
                           double level_mm, int steps);

}  // namespace endmill
