// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "endmill/process/ball_engagement.h"

namespace endmill {

/// What the chip's thickness is taken for.
enum class ChipModel {
    Paper,  ///< feed per tooth times |sin azimuth|, measured horizontally
    Exact  ///< along the direction of the move: the share of it that is normal to the ball
};

/// The cutting action coefficients: what one tooth's edge cuts, as means over a turn.
///
/// With the azimuth t, xi = +1 in front of the axis and -1 behind it where the edge cuts, and
/// zeta = 1 where it cuts, the means of the integrals over the edge's height dz of
///
///     I1  sin t cos t xi    I2  sin^2 t xi    I3  cos t zeta    I4  sin t zeta
///     I5  sin t xi          I6  zeta          I7  r sin t xi    I8  r zeta
///
/// in radii of the ball, r the distance from the axis. I1, I2, I5, I7 multiply the feed per
/// tooth; under ChipModel::Exact they are the same with the exact chip's area for sin t xi dz.
/// Source: [ParkMaeng, eq. (2), appendices A and B], misprints corrected.
struct CuttingCoefficients {
    double I1;  ///< tangential force of the chip along the feed
    double I2;  ///< tangential force of the chip across the feed
    double I3;  ///< tangential force of the edge along the feed
    double I4;  ///< tangential force of the edge across the feed
    double I5;  ///< area of the chip; axial force
    double I6;  ///< length of edge, as height; axial force of the edge
    double I7;  ///< torque of the chip; 2 pi I7 is the section removed by a tooth
    double I8;  ///< torque of the edge
};

/// Term by term.
CuttingCoefficients sum(const CuttingCoefficients& first,
                        const CuttingCoefficients& second);

/// The share of the cylinder above the ball: the engaged angle at its foot, over its whole
/// length in the stock, l / r0 - 1. With a previous pass that angle has the cosine
/// 1 - R_p cos(mu); in a slot it is pi, at an edge pi/2. Closed.
/// Source: [ParkMaeng, eq. (2)]; paper/notes/ball-engagement.md, section 4.
/// \throws DomainError unless `engagement` is sound.
CuttingCoefficients shank_coefficients(const BallEngagement& engagement,
                                       ChipModel chip = ChipModel::Paper);

/// Largest error of a coefficient that `cutting_coefficients` has by default.
inline constexpr double coefficient_accuracy = 1e-10;

/// The coefficients of `engagement`.
///
/// The engaged region is bounded by smooth arcs, whose ends are roots of closed quartics; by
/// Green's theorem each coefficient is a sum of integrals over these arcs, which are taken by
/// a Gauss-Kronrod rule that halves them until it agrees with its Gauss rule. The shank above
/// the ball is closed. Source: derived in paper/notes/ball-engagement.md.
///
/// \param accuracy largest absolute error of a coefficient without the shank, from 1e-12 to
///                 1e-3; for level moves (lambda = 0) the default gives 1e-11.
/// \throws DomainError for another accuracy, or unless `engagement` is sound.
CuttingCoefficients cutting_coefficients(const BallEngagement& engagement,
                                         ChipModel chip = ChipModel::Paper,
                                         double accuracy = coefficient_accuracy);

/// The coefficients of each of `engagements`, in their order, on all threads.
std::vector<CuttingCoefficients> cutting_coefficients(
    std::span<const BallEngagement> engagements, ChipModel chip = ChipModel::Paper,
    double accuracy = coefficient_accuracy);

/// How fine a table is.
struct CoefficientTableOptions {
    int angles = 17;  ///< of mu and of lambda each, from -80 to 80 degrees; from 2 to 181
    int pick_feeds = 8;  ///< of the pick feed, up to the ball's radius; from 2 to 64
    int depths = 8;      ///< of the depth, up to the ball's radius; from 2 to 64
};

/// Coefficients of cuts beside a previous pass, computed beforehand at the nodes of a grid and
/// interpolated linearly along mu, lambda, pick feed and depth; the shank is added in closed
/// form. Angles are equidistant; ratios are the squares of equidistant numbers, since
/// coefficients begin like roots. The default takes 1.2 MB.
/// Source: [ParkMaeng, section 2.2], the precomputed database.
///
/// Error in any coefficient over the table's range, with the default: 3e-3 at the root of
/// the mean square of the worst coefficient, 2.5e-2 at most; coefficients are 0.05 to 0.3
/// in the mean. Halved steps quarter the first.
class CoefficientTable {
public:
    /// Computes the table, on all threads.
    /// \throws DomainError for options out of their ranges.
    explicit CoefficientTable(ChipModel chip = ChipModel::Paper,
                              const CoefficientTableOptions& options = {});

    /// The coefficients of `engagement`. What lies beyond the table, and a cut that is not
    /// beside a previous pass, is computed to 1e-6.
    /// \throws DomainError unless `engagement` is sound.
    CuttingCoefficients coefficients(const BallEngagement& engagement) const;

    /// Whether the table reaches as far.
    bool covers(const BallEngagement& engagement) const;

private:
    ChipModel chip_;
    CoefficientTableOptions options_;
    // Of nodes, mu running slowest, then lambda, pick feed, depth.
    std::vector<std::array<double, 8>> nodes_;
};

}  // namespace endmill
