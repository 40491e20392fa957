// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// Figure 2 as two pictures side by side in one SVG file. Left: a slope with the offsets
/// of all `cutters`, each of which touches the slope. Right: the reference points of all
/// cutters follow the ball's offset, and the material that each leaves.
/// \param cutters the ball first; all of the same radius. At most three.
std::string offset_pictures(const std::vector<Cutter>& cutters);

}  // namespace endmill
