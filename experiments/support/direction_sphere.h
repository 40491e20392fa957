// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/machine/feasible_directions.h"

namespace endmill {

/// A picture of the sphere of directions with a set: its border, the basis circle (what the tool
/// passes by the tilt, or by R1 of A,B, alone), the lines of the rotary axes that turn and the
/// tool axis at zero, with the names of figure 5 where both ranges end. What lies behind is
/// dashed. Source: [KangSuh, figures 2, 5 and 6].
/// \param legend of the border.
std::string direction_sphere_svg(const FeasibleDirections& set, const std::string& title,
                                 const std::string& legend);

}  // namespace endmill
