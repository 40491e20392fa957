// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/machine/configuration.h"

namespace endmill {

/// The three linear and the three rotary axes with their directions, as an SVG file.
std::string machine_axes_svg(const std::string& title);

/// A sketch of any machine with up to two rotary axes, all axes at zero, as an SVG file: what
/// carries the part below it and what carries the tool above it, in the order of the word, both
/// on one bed. No machine's real shape.
/// \param captions lines below the title.
std::string machine_svg(const MachineConfiguration& machine, const std::string& title,
                        const std::vector<std::string>& captions);

}  // namespace endmill
