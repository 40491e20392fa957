// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "endmill/process/cutting_coefficients.h"

namespace endmill {

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
