// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// The cutting action coefficients of a ball-end mill: exact for any engagement, or
/// interpolated in a table, which is faster.
///
/// Implemented in `cutting_coefficients.cpp` and `coefficient_table.cpp`
/// (CoefficientTable).

#include <array>
#include <span>
#include <vector>

#include "endmill/process/ball_engagement.h"

namespace endmill {

/// The cutting action coefficients of one tooth, as means over a spindle revolution.
///
/// Let t be the azimuth on the cutter. Let xi be 1 in front of the axis and -1 behind it
/// where the edge cuts, and 0 elsewhere. Let zeta be 1 where the edge cuts, and 0
/// elsewhere. Let r be the distance from the axis in radii of the ball. Each coefficient
/// is the mean over a spindle revolution of an integral over the height dz along the
/// edge:
///
///     I1  sin t cos t xi    I2  sin^2 t xi    I3  cos t zeta    I4  sin t zeta
///     I5  sin t xi          I6  zeta          I7  r sin t xi    I8  r zeta
///
/// All are dimensionless: heights are in radii of the ball. I1, I2, I5 and I7 multiply
/// the feed per tooth. With ChipModel::Exact the exact chip area replaces sin t xi dz in
/// them.
/// Source: [ParkMaeng, eq. (2), appendices A and B], with misprints corrected as in
/// docs/methods/ball-end-milling.md, section 2.
struct CuttingCoefficients {
    double I1;  ///< tangential force of the chip, component along the feed
    double I2;  ///< tangential force of the chip, component across the feed
    double I3;  ///< tangential edge force, component along the feed
    double I4;  ///< tangential edge force, component across the feed
    double I5;  ///< area of the chip; axial force of the chip
    double I6;  ///< engaged height of the edge; axial edge force
    double I7;  ///< torque of the chip; 2 pi I7 is the cross-section removed by a tooth
    double I8;  ///< torque of the edge force
};

/// Sum of two sets of coefficients, term by term.
CuttingCoefficients sum(const CuttingCoefficients& first,
                        const CuttingCoefficients& second);

/// Engaged angle phi in rad, 0 to 2 pi: the angle over which a point of the edge cuts
/// during a spindle revolution. The point is at the height of the stock's top or, in
/// deeper stock, where the shank begins.
/// Source: [ParkMaeng, eq. (4)]. The paper does not say at which height phi is taken; the
/// choice is explained in docs/methods/ball-end-milling.md, section 5.
/// \throws DomainError unless `engagement` is sound.
double engaged_angle(const BallEngagement& engagement);

/// Contribution of the shank, the cylinder above the ball, to the coefficients. The shank
/// is taken to cut over `shank_angle` along its whole length in the stock, l/r0 - 1.
/// Closed form.
/// Source: [ParkMaeng, eq. (2)]; paper/notes/ball-engagement.md, section 4.
/// \throws DomainError unless `engagement` is sound.
CuttingCoefficients shank_coefficients(const BallEngagement& engagement,
                                       ChipModel chip = ChipModel::Paper);

/// Default bound of the error of a coefficient.
inline constexpr double coefficient_accuracy = 1e-10;

/// The cutting action coefficients of `engagement`.
///
/// The engaged region of the ball is bounded by smooth arcs, whose end points are roots
/// of quartics with closed coefficients. Green's theorem turns each coefficient into a
/// sum of integrals along these arcs, which an adaptive Gauss-Kronrod rule evaluates. The
/// shank is added in closed form.
/// Source: derived in paper/notes/ball-engagement.md, sections 1 to 4.
///
/// \param engagement the cut.
/// \param chip       definition of the chip thickness.
/// \param accuracy   bound of the absolute error of a coefficient without the shank, from
///                   1e-12 to 1e-3. The default yields 1e-11 for horizontal moves (lambda
///                   = 0).
/// \throws DomainError if the accuracy is outside its range, or unless `engagement` is
///          sound.
CuttingCoefficients cutting_coefficients(const BallEngagement& engagement,
                                         ChipModel chip = ChipModel::Paper,
                                         double accuracy = coefficient_accuracy);

/// The cutting action coefficients of an engagement, and its engaged angle.
struct EngagedCoefficients {
    CuttingCoefficients coefficients;  ///< as `cutting_coefficients`
    double engaged_angle;              ///< rad, as `engaged_angle`
};

/// The results of `cutting_coefficients` and `engaged_angle`, from one description of the
/// engaged region.
/// \throws DomainError as `cutting_coefficients`.
EngagedCoefficients engaged_coefficients(const BallEngagement& engagement,
                                         ChipModel chip = ChipModel::Paper,
                                         double accuracy = coefficient_accuracy);

/// The cutting action coefficients of each of `engagements`, in their order, computed on
/// all threads. The result does not depend on the number of threads.
/// \throws DomainError as for a single engagement.
std::vector<CuttingCoefficients> cutting_coefficients(
    std::span<const BallEngagement> engagements, ChipModel chip = ChipModel::Paper,
    double accuracy = coefficient_accuracy);

/// Number of nodes of a CoefficientTable along each of its axes.
struct CoefficientTableOptions {
    int angles = 17;     ///< for each of mu and lambda, from -80 to 80 degrees; 2 to 181
    int pick_feeds = 8;  ///< for the pick feed, from 0 to the ball radius; 2 to 64
    int depths = 8;      ///< for the depth, from 0 to the ball radius; 2 to 64
};

/// Coefficients of cuts beside a previous pass, computed at the nodes of a grid and
/// interpolated linearly in mu, lambda, pick feed and depth. The shank is added in closed
/// form.
///
/// The nodes of the angles are equidistant. The nodes of the two ratios are squares of
/// equidistant numbers, because the coefficients grow like square roots near 0. The
/// default table takes 1.2 MB.
/// Source: [ParkMaeng, section 2.2], the precomputed database;
/// docs/methods/ball-end-milling.md, section 3.5.
///
/// Error of the worst coefficient over the range of the default table: root mean square
/// below 3e-3, at most 2.5e-2. The coefficients themselves are 0.05 to 0.3 on average.
/// Halving the steps divides the root mean square error by four.
class CoefficientTable {
public:
    /// Computes the table on all threads.
    /// \throws DomainError if an option is outside its range.
    explicit CoefficientTable(ChipModel chip = ChipModel::Paper,
                              const CoefficientTableOptions& options = {});

    /// The coefficients of `engagement`. An engagement that the table does not cover is
    /// computed with an accuracy of 1e-6.
    /// \throws DomainError unless `engagement` is sound.
    CuttingCoefficients coefficients(const BallEngagement& engagement) const;

    /// Whether `engagement` lies within the table: beside a previous pass, both angles
    /// within 80 degrees, and the pick feed at most the ball radius.
    bool covers(const BallEngagement& engagement) const;

private:
    ChipModel chip_;
    CoefficientTableOptions options_;
    // One entry per node; mu runs slowest, then lambda, pick feed, depth.
    std::vector<std::array<double, 8>> nodes_;
};

}  // namespace endmill
