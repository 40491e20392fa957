// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "endmill/figures/axonometric_figure.h"

/// \file
/// Simple solids and arrows in an axonometric figure. Only visible faces are drawn, and
/// later shapes cover earlier ones, so a scene is drawn from back to front.

namespace endmill {

/// Colours of the faces of a solid, in the notation of SVG.
struct SolidColours {
    std::string_view light;   ///< top faces
    std::string_view middle;  ///< faces towards the viewer's left
    std::string_view dark;    ///< the other faces
};

/// Draws a box whose edges are parallel to the axes. \param middle,half_size in mm.
void add_box(AxonometricFigure& figure, const Vec3& middle, const Vec3& half_size,
             const SolidColours& colours);

/// Draws a cylinder between the centres of its ends. Lengths in mm.
void add_cylinder(AxonometricFigure& figure, const Vec3& from, const Vec3& to,
                  double radius, const SolidColours& colours);

/// A circular arrow around an axis.
struct TurnArrow {
    Vec3 middle;    ///< centre of the circle, in mm
    Vec3 axis;      ///< unit vector; the arrow turns about it by the right-hand rule
    double radius;  ///< in mm
};

/// Draws a circular arrow: three quarters of a turn if the viewer looks along the axis,
/// else the half turn in front of it.
void add_turn_arrow(AxonometricFigure& figure, const TurnArrow& arrow,
                    const LineStyle& style);

/// Draws a straight arrow with a head at both ends. Points in mm.
void add_double_arrow(AxonometricFigure& figure, const Vec3& from, const Vec3& to,
                      const LineStyle& style);

}  // namespace endmill
