// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ball-end-milling/figure-4/tables.h"

namespace endmill {

/// Exponents that a least-squares fit in single precision gives.
struct SinglePrecisionFits {
    int tried = 0;       ///< number of fits
    int as_printed = 0;  ///< number of those that round to the printed exponent
    int in_order = 0;  ///< number of the latter that sum the data in their printed order
    double least = 1;
    double greatest = 0;
};

/// Fits in single precision: ten forms of the slope (sums, centred sums, eliminations of
/// the normal equations), every order of summation, the abscissas from the printed
/// quotients, logarithms or angles or from the widths of cut, the ordinates from the
/// speeds or their printed logarithms.
/// \param widths a_e / D of each datum. \param printed_pi the pi of the print.
/// \param printed_alpha with seven decimals.
SinglePrecisionFits single_precision_fits(const PrintedSpeeds& printed,
                                          const std::vector<double>& widths,
                                          double printed_pi, double printed_alpha);

}  // namespace endmill
