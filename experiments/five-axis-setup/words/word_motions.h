// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"
#include "support/named_cells.h"

namespace endmill {

/// Solid angle in sr of the machine's tool directions; 0 if it is not valid.
double motion_sr(const MachineConfiguration& machine, const RotaryLimits& limits);

/// The cells of a machine of two rotary axes, as README.md beside this names them.
NamedCells machine_cells(const MachineConfiguration& machine, const RotaryLimits& limits);

/// Number of different positive areas, to a relative 1e-9.
std::size_t distinct_areas(std::vector<double> areas);

/// Rank of the derivative of the tool axis by the positions of both rotary axes, away from
/// singular positions.
int measured_rank(const MachineConfiguration& machine);

/// The largest |x| of the tool axis in the frame of the part, with both rotary axes in
/// steps of 10 degrees.
double largest_x(const MachineConfiguration& machine);

/// Of all 2160 words of two rotary axes, x, y, z and the bed, the number whose tool axis
/// depends on the order or on the position of the linear axes. Each word is compared with
/// the word of the same rotary letters and bed in `rotary_words`, at three positions of
/// the linear axes.
std::size_t words_that_differ();

}  // namespace endmill
