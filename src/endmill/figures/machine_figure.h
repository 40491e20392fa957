// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/machine/configuration.h"

/// \file
/// Sketches of milling machines: which axes they have, in which order, and what each
/// carries.

namespace endmill {

/// The linear axes X, Y, Z and the rotary axes A, B, C with their positive directions, as
/// an SVG file.
/// Source: after [KangSuh, figure 3].
std::string machine_axes_svg(const std::string& title);

/// A sketch of a machine with up to two rotary axes, all axes at zero, as an SVG file.
/// The axes that carry the part are stacked below it and those that carry the tool above
/// it, in the order of the configuration word; a bed joins both. The shape is schematic.
/// Source: after [KangSuh, figure 4].
/// \param captions lines below the title.
std::string machine_svg(const MachineConfiguration& machine, const std::string& title,
                        const std::vector<std::string>& captions);

}  // namespace endmill
