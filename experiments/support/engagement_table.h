// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/csv.h"
#include "endmill/process/detail/engaged_region.h"
#include "support/named_cells.h"

namespace endmill {

/// Latitude from the tip, rad, of the stock's top on the ball, or of the equator if the top is
/// above it. \pre `engagement` is no air.
double highest_latitude(const BallEngagement& engagement);

/// A line that borders what is engaged, by its name: "front", "previous pass", "wall of the
/// previous pass", "edge" or "stock's top". Points of the unit ball, in the frame of
/// BallEngagement.
struct NamedBorder {
    std::string name;
    std::vector<Vec3> points;
};

/// All borders of the engaged part of the ball, those of the stock's top last.
/// \throws DomainError unless `engagement` is sound; if it is air.
std::vector<NamedBorder> named_borders(const BallEngagement& engagement);

/// The borders as a table: border, piece (from 0), x_mm, y_mm, z_mm in the frame of
/// BallEngagement, latitude_deg, azimuth_deg.
CsvTable border_table(const std::vector<NamedBorder>& borders, double radius_mm);

/// What is engaged at a latitude, in rad: ranges, their from_deg and to_deg (the first and the
/// last end), engaged_deg; and sampled_deg, the same angle by asking `is_engaged` at so many
/// azimuths.
NamedCells latitude_cells(const BallEngagement& engagement, double latitude, int samples);

/// I6 of the ball, the mean length of edge in the cut, as a height in radii: the sum of the
/// engaged ranges of `latitudes` equal steps, each taken at its middle.
double i6_by_ranges(const BallEngagement& engagement, int latitudes);

}  // namespace endmill
