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

/// Engagement at a latitude in rad: number of ranges, from_deg and to_deg (begin of the
/// first and end of the last), engaged_deg, and sampled_deg: the engaged angle by
/// `is_engaged` at `samples` azimuths.
NamedCells latitude_cells(const BallEngagement& engagement, double latitude, int samples);

/// I6 of the ball, the mean height of the engaged edge in radii: the sum of the engaged
/// ranges over `latitudes` equal steps, each evaluated at its middle.
double i6_by_ranges(const BallEngagement& engagement, int latitudes);

}  // namespace endmill
