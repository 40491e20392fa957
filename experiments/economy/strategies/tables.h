// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/cutter/cutter.h"
#include "endmill/files/csv.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The cutter and the scallop height of a comparison. The inner tolerance is a hundredth of
/// the scallop height, at least 0.001 mm, so that the bound means something.
struct ComparedCut {
    BallCutter ball;
    double scallop_height;  ///< mm
};

/// An empty table with the columns of this experiment.
CsvTable strategies_table();

/// Adds a row for each strategy on `surface`.
/// \param table   of strategies_table.
/// \param name    of the surface.
/// \param surface the part.
/// \param cut     ball and scallop height.
void add_strategies(CsvTable& table, const std::string& name, const Surface& surface,
                    const ComparedCut& cut);

}  // namespace endmill
