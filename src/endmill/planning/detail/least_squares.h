// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Residuals of given values, always the same number; nothing where they do not exist.
using Residuals = std::function<std::optional<Eigen::VectorXd>(std::span<const double>)>;

/// Values with the smallest sum of squares that a search found.
struct LeastSquares {
    std::vector<double> values;  ///< within the ranges
    double squares;              ///< infinite if the residuals do not exist at the start
    int evaluations;             ///< of the residuals
};

/// Minimises the sum of squares of `residuals` over a box from `start` by the method of Levenberg and
/// Marquardt. Derivatives are differences over 1e-6 of the ranges. It ends after `iterations`, when the
/// squares fall below 1e-12, or when no step of 1e-9 of the ranges is better. The result is never worse than
/// the start, and depends on the arguments only.
/// \param start within the ranges.
LeastSquares least_squares(std::span<const Interval> ranges, const Residuals& residuals,
                           std::vector<double> start, int iterations);

}  // namespace endmill
