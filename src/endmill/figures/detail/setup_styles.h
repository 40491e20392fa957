// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/setup_figures.h"

namespace endmill {

/// An axis as pictures show it.
struct SetupAxis {
    SetupObject object;
    Vec3 axis;              ///< unit, in the machine's directions
    bool is_half_line;      ///< the tool axis, on the spindle's side; others are whole
    std::string_view name;  ///< at its end
};

/// The axes of a setup, each line once: in C,A the first rotary axis is the tool axis.
std::vector<SetupAxis> setup_axes(const RotaryFrame& machine_directions);

/// How a line of a setup is drawn.
LineStyle setup_style(SetupObject object);

/// The same behind what hides it.
LineStyle hidden_style(SetupObject object);

/// Lines of the legend for the axes.
void add_setup_legend(AxonometricFigure& figure, const RotaryFrame& machine_directions);

/// Lines of the legend for the borders of the motion.
void add_border_legend(AxonometricFigure& figure, bool has_limits);

}  // namespace endmill
