// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/experiment.h"

namespace endmill {

/// Draws [KimChoi, fig. 12 or 13]: the path along `direction` with the surface, ball and
/// tolerances of params.json. Writes toolpath.svg, toolpath.csv, worst-pass.csv and a result
/// that compares the figure's caption with the tables. The drawing marks the steps that leave
/// the surface by more than twice the tolerance; worst-pass.csv is the section of the surface
/// along the pass with the worst of them.
///
/// Result rows: the surface's name, as planned; "tables", the printed cells of the same
/// run; "caption", with the number of points in the caption (published.csv, row "tables",
/// column "ncl"). `link_mm` is the length of the links: planned, or TCD - s NCL with the
/// mean segment s from the cells of the other two balls, on the assumption that segment
/// and links are the same for all balls. `reduction_percent` is that of table 1.
/// `worst_step_mm` is the largest distance of the surface along a pass from its steps.
void draw_tool_path(Experiment& experiment, Parameter direction);

}  // namespace endmill
