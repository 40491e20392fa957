// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "endmill/figures/axonometric_figure.h"

namespace endmill {

/// Colours of a solid, as SVG writes them: of its top, of what faces the viewer most, and of
/// the rest.
struct SolidColours {
    std::string_view light;
    std::string_view middle;
    std::string_view dark;
};

/// An upright box along the axes: the faces that are seen. What is drawn later covers it.
/// \param middle, half_size in mm.
void add_box(AxonometricFigure& figure, const Vec3& middle, const Vec3& half_size,
             const SolidColours& colours);

/// A cylinder between two places, in mm: what is seen of it.
void add_cylinder(AxonometricFigure& figure, const Vec3& from, const Vec3& to,
                  double radius, const SolidColours& colours);

/// Where and how far an arrow goes round.
struct TurnArrow {
    Vec3 middle;    ///< mm
    Vec3 axis;      ///< unit; the arrow goes round it by the right-hand rule
    double radius;  ///< mm
};

/// That arrow, three quarters of a turn around an axis that is seen from its end, else the half
/// in front of it.
void add_turn_arrow(AxonometricFigure& figure, const TurnArrow& arrow,
                    const LineStyle& style);

/// A straight arrow with a head at both ends, in mm.
void add_double_arrow(AxonometricFigure& figure, const Vec3& from, const Vec3& to,
                      const LineStyle& style);

}  // namespace endmill
