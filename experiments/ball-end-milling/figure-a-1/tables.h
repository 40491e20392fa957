// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/figures/force_figures.h"
#include "endmill/files/csv.h"

namespace endmill {

/// Adds the numbers of `force_frame_svg` to a table. The rows "NAME, X", "…, Y", "…, Z",
/// "…, P" (the element, in mm), "…, F_T", "…, F_R" and "…, F_z" have x, y, z in the axes
/// of the figure; "…, theta" has from_deg, to_deg (the engaged range at the element's
/// latitude) and at_deg. `along_motion` is the cosine between a force and the motion of
/// the element under a spindle that turns clockwise seen from above; `outwards` is the
/// cosine between a force and the horizontal radius to the element.
void add_frame_rows(CsvTable& table, const std::string& name, const EdgeElement& element,
                    const BallFrame& frame);

}  // namespace endmill
