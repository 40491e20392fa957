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
#include "endmill/path/tool_path.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/feed_plan.h"
#include "endmill/stock/removal.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/trimming.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// How much of the part has how much left on it, as a CSV file with the columns `from_mm`,
/// `to_mm` and `area_mm2`.
///
/// Bins have the width (scallop limit + tolerance) / 100 and go from -2 tolerances to 2
/// scallop limits; beyond it all is in the outermost. Rows are those from the least to the
/// greatest value, where the first begins and the last ends. A value between two bins is
/// in the upper one. The areas sum to `area_mm2` within rounding.
/// \throws DomainError unless both limits are finite and positive, and the deviation has
///         a finite value and area for each cell.
std::string deviation_histogram_csv(const Deviation& deviation,
                                    const DeviationLimits& limits);

/// The geometry of each cutting move and the feed that it allows, as a CSV file with a row a
/// move and the columns pass, point, length_mm, mu_deg, lambda_deg, pick_feed_mm,
/// pick_feed_horizontal_mm, depth_mm, engaged_angle_deg, feed_per_tooth_mm, peak_factor, limit,
/// speed_limit, cutting_force_n, thrust_n, torque_n_m, power_w; a cell is empty where there
/// is nothing to tell. Angles are rounded to 1e-9 degrees.
/// \throws DomainError unless there is a row for each of `cuts`, and every number is finite.
std::string feed_csv(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows);

/// Forces over a turn as a CSV file with a row an angle and the columns theta_deg,
/// force_x_n, force_y_n, force_z_n, torque_n_m, in the frame of CuttingForce.
/// \param angles of the cutter, rad, one a force; written in degrees, rounded to 1e-9.
/// \throws DomainError unless there is an angle for each force, and every number is finite.
std::string force_profile_csv(std::span<const double> angles,
                              std::span<const CuttingForce> forces);

/// What each move took, as a CSV file with a row a point and the columns `point` (from 0
/// in the whole path), `length_mm` of the move that leads to it (0 for the first),
/// `removed_mm3` and `rate_mm3_per_min`. The rate is empty without a feed, for a rapid,
/// which does not go at it, and for a move without length.
/// \throws DomainError unless there is a volume for each point, conditions for none or
///         for all, and every number is finite.
std::string removal_csv(const Removal& removal, const ToolPath& path);

/// The engaged part of the cutter on each move, as a CSV file with a row for each interval
/// of each ring and the columns `point` (from 0 in the whole path), `latitude_deg`,
/// `radius_mm`, `above_tip_mm`, `from_deg` and `to_deg`, as in `Engagement`. Angles are
/// rounded to 1e-9 degrees. Handed out in pieces of a few MiB at most: the rows of a long
/// path need not fit the memory.
class EngagementCsv {
public:
    /// Takes the next piece of the file.
    using Sink = std::function<void(std::string_view piece)>;

    /// \param sink takes the pieces in order; the first begins with the header.
    explicit EngagementCsv(Sink sink);

    /// Adds the rows of the move to point `number`; none if nothing is engaged.
    /// \throws DomainError if a number is not finite.
    void add(std::size_t number, const Engagement& engagement);

    /// Hands out what is left, after the last move.
    void finish();

private:
    Sink sink_;
    std::string text_;  // not handed out yet
};

/// The curves of each plane before trimming as a CSV file of the columns plane, curve,
/// point, s_mm, x_mm, y_mm, z_mm: reference points, a row a point, numbers from 0.
/// \param placed where the planes stand; null leaves x and y empty.
/// \throws DomainError if a number is not finite, or the planes are fewer than the curves'.
std::string sections_csv(std::span<const std::vector<SectionCurve>> planes,
                         const DrivePlanes* placed);

/// The same of what is left.
std::string trimmed_csv(std::span<const Trimmed> planes, const DrivePlanes* placed);

/// What was cut out as a CSV file of the columns plane, curve, s_mm, z_mm, first_point,
/// last_point, cause and, if `explained`, rule, a row a stretch; curve and points are
/// those of `sections_csv`, s and z empty where the stretch ends in no place.
/// \throws DomainError if a number is not finite.
std::string loops_csv(std::span<const std::vector<CutOut>> planes, bool explained);

/// Writes the map as the paper has it, to `sink`: after `facet` the columns `cell_0`, `cell_1`
/// and so on, a row a facet; 0 where the facet is accessible, else 1. Source: [KangSuh,
/// section 2].
void write_visibility_csv(const VisibilityMap& map, const OutputFolder::Sink& sink);

/// The columns `facet` and `visible_fraction`: the share of the sphere that its cone has,
/// cells by their solid angles; unknown for a facet without area.
/// \param solid_angles_sr of the cells. \throws DomainError unless there is one a cell.
std::string cones_csv(const PartVisibility& visibility,
                      std::span<const double> solid_angles_sr);

}  // namespace endmill
