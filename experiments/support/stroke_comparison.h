// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/detail/stroke_forces.h"
#include "support/named_cells.h"

namespace endmill {

/// Cells of a stroke: minutes, removed_mm3_per_min, force_x_n, force_y_n, thrust_n, downhill_x_n,
/// downhill_y_n, downhill_thrust_n.
NamedCells stroke_cells(const StrokeForces& stroke);

/// One stroke at a constant and at a varied feed.
struct StrokeComparison {
    StrokeForces constant;
    StrokeForces varied;
    /// One row for each move and feed: travel_mm at the middle of the move, feed ("constant" or
    /// "varied"), and the range of the force over the turn there: least_x_n, greatest_x_n,
    /// likewise y and z.
    CsvTable along;
};

/// Compares the forces of two lists of moves along the same stroke.
/// \param steps number of azimuths a turn.
StrokeComparison compared_strokes(const std::vector<MilledMove>& constant,
                                  const std::vector<MilledMove>& varied,
                                  const MillingJob& job, int steps);

/// Forces over one turn at the middle move of a stroke: row, theta_deg, feed ("constant" or
/// "varied"), force_x_n, force_y_n, force_z_n. \param steps number of azimuths a turn.
CsvTable middle_turn(const std::vector<MilledMove>& constant,
                     const std::vector<MilledMove>& varied, const MillingJob& job,
                     int steps);

/// Whether the varied feed takes less time (and so removes more material a minute) with smaller
/// force peaks along x and y. Source: [ParkMaeng, section 5].
bool is_faster_with_smaller_peaks(const StrokeComparison& compared);

/// Whether the downhill peak of the thrust falls by a smaller share than the peaks along x and y;
/// false for a stroke without downhill moves. Source: [ParkMaeng, section 5].
bool downhill_thrust_hardly_falls(const StrokeComparison& compared);

/// The columns of `stroke_cells` (without removed_mm3_per_min) at the varied feed as shares of
/// those at the constant feed, and both claims as "yes" or "no" under the names of the functions,
/// without `is_`.
/// \pre the stroke has downhill moves.
NamedCells claim_cells(const StrokeComparison& compared);

/// Number of passes for which each claim holds, under the same names.
/// \param constant_mm the constant feed per tooth, mm.
NamedCells claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                        double constant_mm, int steps);

}  // namespace endmill
