// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/detail/stroke_forces.h"
#include "support/named_cells.h"

namespace endmill {

/// Coefficients of variation of the largest magnitude of each force in a turn, over the
/// length of a stroke.
struct ForceVariation {
    double x = 0;       ///< along the feed
    double y = 0;       ///< across the feed
    double thrust = 0;  ///< along the axis
};

/// Cells of a stroke: minutes, removed_mm3_per_min, force_x_n, force_y_n, thrust_n, downhill_x_n,
/// downhill_y_n, downhill_thrust_n, x_variation, y_variation, thrust_variation.
NamedCells stroke_cells(const StrokeForces& stroke, const ForceVariation& variation);

/// One stroke at a constant and at a varied feed.
struct StrokeComparison {
    StrokeForces constant;
    StrokeForces varied;
    ForceVariation constant_variation;
    ForceVariation varied_variation;
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

/// A claim of the paper on a stroke, and the name of its column.
/// Source: [ParkMaeng, section 5].
struct StrokeClaim {
    std::string name;
    bool (*holds)(const StrokeComparison&);
};

/// The claims on a stroke: removal_rises, less time for the same material; peaks_fall,
/// smaller largest forces along x and y; faster_with_smaller_peaks, both;
/// xy_forces_disperse and thrust_disperses, smaller coefficients of variation;
/// downhill_thrust_hardly_falls, whose downhill peak falls by a smaller share than the
/// peaks along x and y (false for a stroke without downhill moves).
const std::vector<StrokeClaim>& stroke_claims();

/// The columns of `stroke_cells` (without removed_mm3_per_min) at the varied feed as shares of
/// those at the constant feed; x_variation, y_variation and thrust_variation likewise;
/// and whether each of `stroke_claims` holds.
/// \pre the stroke has downhill moves.
NamedCells claim_cells(const StrokeComparison& compared);

/// Number of passes for which each of `stroke_claims` holds.
/// \param constant_mm the constant feed per tooth, mm.
NamedCells claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                        double constant_mm, int steps);

/// Number of passes that take less time with a smaller largest force by eq. (15):
/// faster_with_smaller_peaks. \param peak_factor R_m.
NamedCells stated_claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                               double constant_mm, double peak_factor);

/// Charts of StrokeComparison::along, the largest magnitude of each force in a turn over
/// the way along the stroke, and of `middle_turn`, as SVG files: one panel for each force
/// and one colour for each feed, the same in both.
std::string along_figure(const std::string& title, const CsvTable& along);
std::string turn_figure(const std::string& title, const CsvTable& turn);  ///< see above

}  // namespace endmill
