// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 13 of Kim & Choi: the contacts of the path along v in cutting order, on a net
// fitted to the tables; and the figure's caption compared with the tables.
//
//   economic-cl-data-figure-13 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "support/tool_path_figure.h"

int main(int argc, char** argv)
{
    return endmill::run_experiment(
        argc, argv, "economic-cl-data/figure-13",
        [](endmill::Experiment& run) { draw_tool_path(run, endmill::Parameter::V); });
}
