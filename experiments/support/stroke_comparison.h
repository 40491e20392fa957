// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/process/feed_plan.h"
#include "endmill/process/detail/stroke_forces.h"

namespace endmill {

/// The moves at the feed per tooth and speed of their plan; or at the same speeds and one feed
/// per tooth, in mm.
std::vector<MilledMove> milled_moves(const std::vector<SegmentCut>& cuts,
                                     const FeedPlan& plan,
                                     const std::optional<double>& feed_per_tooth_mm);

/// A stroke at a constant and at a varied feed.
struct StrokeComparison {
    StrokeForces constant;
    StrokeForces varied;
    /// A row a move and feed: travel_mm at its middle, feed ("constant" or "varied"), and of
    /// the turn there least_x_n, greatest_x_n, likewise y and z.
    CsvTable along;
};

/// \param steps azimuths a turn.
StrokeComparison compared_strokes(const std::vector<MilledMove>& constant,
                                  const std::vector<MilledMove>& varied,
                                  const MillingJob& job, int steps);

/// Forces over a turn at the middle move of a stroke: row, theta_deg, feed ("constant" or
/// "varied"), force_x_n, force_y_n, force_z_n. \param steps azimuths a turn.
CsvTable middle_turn(const std::vector<MilledMove>& constant,
                     const std::vector<MilledMove>& varied, const MillingJob& job,
                     int steps);

/// Whether the varied feed takes less time, and so removes more a minute, with smaller peaks
/// along x and y. Source: [ParkMaeng, section 5].
bool is_faster_with_smaller_peaks(const StrokeComparison& compared);

/// Whether the thrust's peak downhill falls by a smaller share than those along x and y over
/// the stroke; no if nothing goes downhill. Source: as above.
bool downhill_thrust_hardly_falls(const StrokeComparison& compared);

/// What is left of the columns of `stroke_cells`, but for removed_mm3_per_min, by varying the
/// feed, as shares; and both claims, "yes" or "no", by their names, without `is_`.
/// \pre The stroke goes downhill somewhere.
NamedCells claim_cells(const StrokeComparison& compared);

/// Of how many passes both claims hold, by the same names.
/// \param constant_mm the constant feed per tooth.
NamedCells claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                        double constant_mm, int steps);

}  // namespace endmill
