// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"
#include "support/named_cells.h"

namespace endmill {

/// Lengths of the moves, mm.
std::vector<double> lengths_of(const std::vector<SegmentCut>& cuts);

/// Table feeds of the moves, mm/min.
std::vector<double> table_feeds(const FeedPlan& plan);

/// Standard deviation of `values`, each with its weight.
double deviation(std::span<const double> values, std::span<const double> weights);

/// Coefficient of variation: `deviation` over the weighted mean.
double variation(std::span<const double> values, std::span<const double> weights);

/// The least value that is not exceeded by values of at least `share` of the weight.
double weighted_quantile(std::span<const double> values, std::span<const double> weights,
                         double share);

/// Spearman's rank correlation of two lists of equal size. Equal values share their mean
/// rank.
double rank_correlation(const std::vector<double>& one, const std::vector<double>& other);

/// Moves whose tip is cut over the full ring, in percent of the length: the feed goes
/// down and every azimuth cuts at half the latitude of the slope. The cut then resembles
/// drilling.
double full_ring_percent(const std::vector<SegmentCut>& cuts, double radius);

/// Geometry along a path: standard deviations over the length (mu_deviation_deg,
/// lambda_deviation_deg, pick_feed_deviation_mm, depth_deviation_mm), mean changes per mm
/// within a pass (mu_change, lambda_change, pick_feed_change, depth_change) and
/// depth_reversals_per_100_mm.
NamedCells geometry_variation(const std::vector<SegmentCut>& cuts);

/// Feed along a path: feed_50, feed_95, feed_99 and feed_greatest, quantiles over the
/// length in mm/min; feed_variation; feed_reversals_per_100_mm; feed_change, the mean
/// relative change per mm within a pass. \param feeds mm/min, one for each cut.
NamedCells feed_distribution(const std::vector<SegmentCut>& cuts,
                             const std::vector<double>& feeds);

}  // namespace endmill
