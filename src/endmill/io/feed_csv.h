// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cut.h"

namespace endmill {

/// The geometry of each cutting move and the feed that it allows, as a CSV file with a row a
/// move and the columns pass, point, length_mm, mu_deg, lambda_deg, pick_feed_mm,
/// pick_feed_horizontal_mm, depth_mm, engaged_angle_deg, feed_per_tooth_mm, peak_factor, limit,
/// speed_limit, cutting_force_n, thrust_n, torque_n_m, power_w; a cell is empty where there
/// is nothing to tell. Angles are rounded to 1e-9 degrees.
/// \throws DomainError unless there is a row for each of `cuts`, and every number is finite.
std::string feed_csv(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows);

}  // namespace endmill
