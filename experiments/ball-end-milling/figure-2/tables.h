// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/figures/force_figures.h"
#include "endmill/files/csv.h"
#include "support/named_cells.h"

namespace endmill {

/// The borders as a table: border, piece (from 0), x_mm, y_mm, z_mm in the frame of
/// BallEngagement, latitude_deg, azimuth_deg.
CsvTable border_table(const std::vector<EngagementBorder>& borders, double radius_mm);

/// What is engaged at a latitude, in rad: ranges, their from_deg and to_deg (the first
/// and the last end), engaged_deg; and sampled_deg, the same angle by asking `is_engaged`
/// at so many azimuths.
NamedCells latitude_cells(const BallEngagement& engagement, double latitude, int samples);

/// I6 of the ball, the mean length of edge in the cut, as a height in radii: the sum of
/// the engaged ranges of `latitudes` equal steps, each taken at its middle.
double i6_by_ranges(const BallEngagement& engagement, int latitudes);

}  // namespace endmill
