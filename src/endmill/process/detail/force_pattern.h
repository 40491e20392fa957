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

/// What all edges of a helical ball-end mill bear while it turns: at the turn t, with the
/// azimuths u = t + 2 pi j / m - z tan(helix) of its flutes j and heights z in ball
/// radii,
///
///     A = sum of |sin u| dz    B = sum of dz    A_T = sum of r |sin u| dz    B_T = sum of r dz
///
/// (for the sense of the helix see HelicalEdge: when milling down a right-hand cutter
/// under M03 is told by a negative one) over what is engaged, r the distance from the
/// axis; with the exact chip its thickness for |sin u|. Over a turn their means are m I5,
/// m I6, m I7, m I8. Which edges cut is found from the borders of the engaged region
/// (HelicalEdge); the sums over them are closed, but that of r sin u, which is tabulated
/// along the latitude to 1e-13.
/// Source: [ParkMaeng, appendices A and B]; the paper's five torque patterns are not
/// printed, this stands for them: paper/notes/ball-engagement.md, section 5.
class ForcePattern {
public:
    /// \throws DomainError unless `engagement` and `tool` are sound, and as HelicalEdge.
    ForcePattern(const BallEngagement& engagement, ChipModel chip,
                 const MillingTool& tool);

    /// The sums when flute 0 stands at the azimuth `turn` (rad, any) at the tip. Absolute
    /// error below 1e-11, but within 1e-6 of a turn at which an edge touches a border:
    /// 1e-5.
    EdgeSums at(double turn) const;

    /// Their means over a turn, as `cutting_coefficients` gives them.
    EdgeSums mean() const;

    /// R_m, the concentration of force: the largest torque of the chip, A_T, over its
    /// mean. 1 where nothing is cut. Relative error below 1e-6.
    double peak_factor() const;

    /// The largest feeds per tooth in mm at which no limit is passed at any time of the
    /// turn: the least over t of `feed_bounds`. Relative error below 1e-6.
    /// \pre as `feed_bounds`.
    FeedBounds direct_bounds(const LoadModel& model, const LoadLimits& limits) const;

    /// The largest of each load over a turn at a feed per tooth. Relative error below
    /// 1e-6.
    CuttingLoads largest_loads(const LoadModel& model, double feed_per_tooth_mm) const;

private:
    struct Sample {
        double turn;
        EdgeSums sums;
    };
    using Measure = std::function<double(const EdgeSums&)>;

    void add_stretch(const HeightRange& stretch, double turn, EdgeSums& sums) const;
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
    // Integrals of sin^2 cos(z tan) and sin^2 sin(z tan) from the tip to latitudes.
    std::vector<std::array<double, 2>> moments_;
    std::vector<std::vector<Sample>>
        samples_;  // between events each, in the flutes' period
};

}  // namespace endmill
