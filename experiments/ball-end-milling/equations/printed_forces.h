// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// Adds a row with the deviation of each printed equation on the forces:
///
/// - "eq. (1)": the printed matrix, which is said to be that of down milling, against the
///   mean force; largest |difference| over |force|.
/// - "eq. (2), I1" to "I8": the printed form, summed over the engaged azimuths ring by
///   ring, against the coefficient by its definition; largest |difference|.
/// - "eq. (3)": equivalent radius over r0, with I4 as printed.
/// - "appendix A, means": mean of the forces in time over a turn, over |force|.
/// - "appendix A, down milling": the printed matrix against forces of the mirrored cut
///   that milling down is.
/// - "appendix B, I6 with xi": the mean of xi, as printed, against that of zeta.
/// - "appendix B, end": C3 as axial coefficient, as printed, against C5.
///
/// \param engagements cuts with a depth of at least the radius, for which eq. (2) holds.
/// \param feed_mm feed per tooth.
void add_force_equations(CsvTable& result, const std::vector<BallEngagement>& engagements,
                         const MillingJob& job, double feed_mm);

/// Adds:
///
/// - "eq. (16)", "eq. (17)": thrust and torque as printed, without R_m, against those of
///   the mean force of appendix A; relative.
/// - "appendix B, end, torque": C5 as torque coefficient of the chip, as printed, against
///   C7, for a radius of 1.
/// - "appendix B, end, edge": C4, C3 and C7 in the edge term, as printed, against C3, C4
///   and C6, for a radius of 1.
void add_printed_limits(CsvTable& result, const std::vector<BallEngagement>& engagements,
                        const MillingJob& job, double feed_mm);

}  // namespace endmill
