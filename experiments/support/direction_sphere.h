// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/machine/feasible_directions.h"

namespace endmill {

/// A picture of the sphere of directions with the border of a set, the lines of the rotary axes
/// and the tool axis at zero. What lies behind is dashed.
/// \param legend of the border.
std::string direction_sphere_svg(const FeasibleDirections& set, const std::string& title,
                                 const std::string& legend);

}  // namespace endmill
