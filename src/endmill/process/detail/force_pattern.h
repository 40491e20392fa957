// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/detail/helical_edge.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// Sums over all edges of a helical ball-end mill during a spindle revolution. Let t be
/// the azimuth of the tip of flute 0. Flute j then has the azimuth u = t + 2 pi j / m - z
/// tan(helix) at the height z (in radii of the ball), and
///
///     A   = sum of the integrals of |sin u| dz      B   = sum of the integrals of dz
///     A_T = sum of the integrals of r |sin u| dz    B_T = sum of the integrals of r dz
///
/// over the engaged heights, where r is the distance from the axis. With the exact chip
/// its thickness replaces |sin u|. The means over a revolution are m I5, m I6, m I7 and m
/// I8. The sense of the helix is explained at MillingTool::helix.
///
/// 1. HelicalEdge gives the engaged heights of each edge from the borders of the region.
/// 2. The sums over these heights are closed, except that of r sin u, which is tabulated
///    over the latitude to 1e-13.
/// 3. Between the events of HelicalEdge the sums are smooth in t. Nine samples per
///    interval locate the maximum of any function of the sums, and golden-section search
///    refines it.
/// Source: [ParkMaeng, appendices A and B]; the paper does not print its five torque
/// patterns, and these sums replace them: paper/notes/ball-engagement.md, section 5.
class ForcePattern {
public:
    /// \throws DomainError unless `engagement` and `tool` are sound, and as HelicalEdge.
    ForcePattern(const BallEngagement& engagement, ChipModel chip,
                 const MillingTool& tool);

    /// The sums while the tip of flute 0 is at the azimuth `turn` (rad, any value).
    /// Absolute error below 1e-11; below 1e-5 within 1e-6 of an azimuth at which an edge
    /// touches a border.
    EdgeSums at(double turn) const;

    /// Means of the sums over a revolution, from `cutting_coefficients`.
    EdgeSums mean() const;

    /// Peak factor R_m: the largest torque of the chip A_T over its mean. 1 if nothing is
    /// cut. Relative error below 1e-6.
    double peak_factor() const;

    /// Largest feeds per tooth in mm at which no limit is exceeded at any time of the
    /// revolution: the minimum over t of `feed_bounds`. Relative error below 1e-6.
    /// \pre as `feed_bounds`.
    FeedBounds direct_bounds(const LoadModel& model, const LoadLimits& limits) const;

    /// Largest value of each load in a revolution at a feed per tooth. Relative error
    /// below 1e-6.
    CuttingLoads largest_loads(const LoadModel& model, double feed_per_tooth_mm) const;

private:
    struct Sample {
        double turn;
        EdgeSums sums;
    };
    using Measure = std::function<double(const EdgeSums&)>;

    void add_range(const EdgeRange& range, double turn, EdgeSums& sums) const;
    std::array<double, 2> torque_moments(double latitude) const;
    std::array<double, 2> moments_from(int below, double latitude) const;
    void tabulate_moments();
    void sample();
    double largest(const Measure& measure) const;
    double largest_between(const Measure& measure, double low, double high) const;

    BallEngagement engagement_;
    ChipModel chip_;
    int flutes_;
    double cos_lambda_;
    double sin_lambda_;
    HelicalEdge edge_;
    // Integrals of sin^2 cos(z tan(helix)) and sin^2 sin(z tan(helix)) over the latitude,
    // from the tip to equidistant latitudes.
    std::vector<std::array<double, 2>> moments_;
    std::vector<std::vector<Sample>> samples_;  // per interval between events
};

}  // namespace endmill
