// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/process/detail/one_way_passes.h"

namespace endmill {

/// The tips of a path in parallel projection, as an SVG file: one pass, the stroke A, is
/// bold and labelled; lifts, returns and plunges are faint.
/// Source: after [ParkMaeng, fig. 7].
/// \param safe_z height of the returns, mm. \param stroke number of the pass from 0.
std::string stroke_path_figure(const MilledPath& milled, double radius, double safe_z,
                               int stroke);

}  // namespace endmill
