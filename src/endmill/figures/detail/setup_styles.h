// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/setup_figures.h"

/// \file
/// Styles and legends that the figures of a setup share.

namespace endmill {

/// An axis as figures draw it.
struct SetupAxis {
    SetupObject object;     ///< which axis it is
    Vec3 axis;              ///< unit vector in coordinates of the machine
    bool is_half_line;      ///< drawn on the positive side only: the tool axis
    std::string_view name;  ///< written at its end
};

/// Colours of a facet, from one seen edge-on to one that faces the viewer.
using Shades = std::array<std::string_view, 5>;

/// The shades of grey of facets that are seen from behind or do not matter.
inline constexpr Shades grey_shades{"#6e6e6e", "#868686", "#9c9c9c", "#b2b2b2",
                                    "#c6c6c6"};

/// The shade for a facet whose normal has this cosine with the direction to the viewer.
std::string_view shade(const Shades& shades, double cosine);

/// The axes of a setup, each line once: in the family C,A the axis R1 is the tool axis.
std::vector<SetupAxis> setup_axes(const RotaryFrame& machine_directions);

/// The style of the lines of an object.
LineStyle setup_style(SetupObject object);

/// The style of the same lines where they are hidden.
LineStyle hidden_style(SetupObject object);

/// Adds the axes to the legend.
void add_setup_legend(AxonometricFigure& figure, const RotaryFrame& machine_directions);

/// Adds the borders of the motion to the legend; that of the machine if its limits are
/// known.
void add_border_legend(AxonometricFigure& figure, const ShownSetup& setup);

}  // namespace endmill
