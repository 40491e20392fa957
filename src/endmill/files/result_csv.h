// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/deviation/deviation.h"
#include "endmill/files/output_folder.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/slicer.h"
#include "endmill/path/tool_path.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/feed_plan.h"
#include "endmill/stock/removal.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/trimming.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Results as CSV files, one function for each kind of result. Every column name carries
/// the unit of its numbers; an unknown value is an empty cell.
///
/// Implemented in one source file for each kind of result, such as `deviation_csv.cpp`
/// and `feed_csv.cpp`.

namespace endmill {

/// Histogram of the deviation over the area of the part, as a CSV file with the columns
/// `from_mm`, `to_mm` and `area_mm2`.
///
/// Bins have the width (scallop limit + tolerance) / 100 and cover -2 tolerances to 2
/// scallop limits; values outside fall into the first or last bin. Only bins between the
/// least and the greatest value are written. These two values replace the outer edges. A
/// value on an edge belongs to the upper bin. The areas sum to the measured area within
/// rounding.
/// \throws DomainError unless both limits are finite and positive, and every cell has a
///         finite value and area.
std::string deviation_histogram_csv(const Deviation& deviation,
                                    const DeviationLimits& limits);

/// Geometry and allowed feed of each cutting move, as a CSV file with one row for each
/// move and the columns pass, point, length_mm, mu_deg, lambda_deg, pick_feed_mm,
/// pick_feed_horizontal_mm, depth_mm, engaged_angle_deg, feed_per_tooth_mm, peak_factor,
/// limit, speed_limit, cutting_force_n, thrust_n, torque_n_m, power_w. Angles are rounded
/// to 1e-9 degrees.
/// \throws DomainError unless there is one row for each of `cuts` and every number is
///         finite.
std::string feed_csv(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows);

/// The same text in pieces, for a path whose text need not fit into memory as a whole.
/// \param sink receives the pieces in order.
/// \throws as `feed_csv`, and whatever `sink` throws.
void write_feed_csv(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                    const std::function<void(std::string_view piece)>& sink);

/// The rows of `feed_csv` without its header, made by the calling thread alone.
/// Parameters and errors are those of `feed_csv`.
std::string feed_rows(std::span<const SegmentCut> cuts,
                      std::span<const SegmentFeed> rows);

/// The rows of `feed_csv` without its header, to continue a file that `write_feed_csv` began.
/// Parameters and errors are those of `write_feed_csv`.
void write_feed_rows(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                     const std::function<void(std::string_view piece)>& sink);

/// Cutting forces over a turn, as a CSV file with one row for each angle and the columns
/// theta_deg, force_x_n, force_y_n, force_z_n, torque_n_m, in the frame of CuttingForce.
/// \param angles of the cutter in rad, one for each force; written in degrees, rounded to
///               1e-9 degrees.
/// \throws DomainError unless there is one angle for each force and every number is
///         finite.
std::string force_profile_csv(std::span<const double> angles,
                              std::span<const CuttingForce> forces);

/// Removed volume of each move, as a CSV file with one row for each point and the columns
/// `point` (from 0 in the whole path), `length_mm` of the move that ends there (0 for the
/// first), `removed_mm3` and `rate_mm3_per_min`. The rate is empty for a move without
/// feed, a rapid and a move of length 0.
/// \throws DomainError unless there is a volume for each point and every number is finite.
std::string removal_csv(const Removal& removal, const ToolPath& path);

/// Writes the engagement of the cutter on each move as a CSV file, with one row for each
/// engaged interval of each ring and the columns `point` (from 0 in the whole path),
/// `latitude_deg`, `radius_mm`, `above_tip_mm`, `from_deg` and `to_deg`, as in
/// `Engagement`. Angles are rounded to 1e-9 degrees. The text is passed on in pieces of a
/// few MiB, because the text of a long path may not fit into memory.
class EngagementCsv {
public:
    /// \param sink receives the pieces in order; the first begins with the header.
    explicit EngagementCsv(OutputFolder::Sink sink);

    /// Adds the rows of the move that ends at point `number`; none if nothing is engaged.
    /// \throws DomainError if a number is not finite.
    void add(std::size_t number, const Engagement& engagement);

    /// Passes on the remaining text. Call it after the last move.
    void finish();

private:
    OutputFolder::Sink sink_;
    std::string text_;  // not passed on yet
};

/// The curves of each plane before trimming, as a CSV file of reference points with the
/// columns plane, curve, point (numbers from 0), s_mm, x_mm, y_mm, z_mm.
/// \param placed positions of the planes in space; if null, x and y are empty.
/// \throws DomainError if a number is not finite, or there are fewer positions than
///         planes.
std::string sections_csv(std::span<const PlaneSection> planes, const DrivePlanes* placed);

/// The same text in pieces, made by all threads: the header, then the rows of each plane.
/// \param sink receives the pieces in order.
/// \throws as `sections_csv`, and whatever `sink` throws.
void write_sections_csv(std::span<const PlaneSection> planes, const DrivePlanes* placed,
                        const std::function<void(std::string_view piece)>& sink);

/// The same for the curves after trimming.
std::string trimmed_csv(std::span<const Trimmed> planes, const DrivePlanes* placed);

/// The same text in pieces, as `write_sections_csv`.
void write_trimmed_csv(std::span<const Trimmed> planes, const DrivePlanes* placed,
                       const std::function<void(std::string_view piece)>& sink);

/// Columns of `loops_csv`.
enum class LoopColumns {
    Cause,         ///< up to the cause of each cut
    CauseAndRule,  ///< also the rule of the trimming method that made the cut
};

/// The stretches that trimming removed, as a CSV file with the columns plane, curve,
/// s_mm, z_mm, first_point, last_point, cause and perhaps rule. `curve` and the points
/// are those of `sections_csv`; s and z are empty if nothing remains of the curve.
/// \throws DomainError if a number is not finite.
std::string loops_csv(std::span<const std::vector<CutOut>> planes, LoopColumns columns);

/// Writes a visibility map as the binary matrix of the paper: the column `facet`, then
/// `cell_0`, `cell_1`, ...; one row for each facet; 0 if the facet is accessible along
/// the cell's direction, else 1.
/// Source: [KangSuh, section 2].
void write_visibility_csv(const VisibilityMap& map, const OutputFolder::Sink& sink);

/// The visibility cones as a CSV file with the columns `facet` and `visible_fraction`:
/// the solid angle of the accessible cells over that of the sphere; empty for a facet
/// without area.
/// \param solid_angles_sr solid angle of each cell, in sr.
/// \throws DomainError unless there is one solid angle for each cell.
std::string cones_csv(const PartVisibility& visibility,
                      std::span<const double> solid_angles_sr);

}  // namespace endmill
