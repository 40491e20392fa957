// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/experiment.h"

namespace endmill {

/// [KimChoi, fig. 12 or 13]: the path along `direction` on the surface, with the ball and
/// the tolerances that params.json names. Keeps toolpath.svg, toolpath.csv and a result
/// that sets the figure's caption beside the tables.
///
/// Result rows: the surface's name, what was planned; "tables", the printed cells of the
/// same run; "caption", with the count of the figure's caption (published.csv, row
/// "tables", column "ncl"). `link_mm` is the length of the links: planned, or TCD - s NCL
/// with s from the cells of the other two balls, which is the same for all balls as far
/// as mean segment and links are. `reduction_percent` is that of table 1.
void draw_tool_path(Experiment& experiment, Parameter direction);

}  // namespace endmill
