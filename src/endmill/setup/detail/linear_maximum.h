// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

namespace endmill {

/// A linear objective and linear inequalities in a few unknowns: c . x becomes largest
/// where a . x <= b for each row a, and |x_k| <= box for each unknown.
struct LinearMaximum {
    Eigen::MatrixXd rows;       ///< one row a for each inequality
    Eigen::VectorXd limits;     ///< b of each row
    Eigen::VectorXd objective;  ///< c
    double box = 1e6;           ///< of every unknown, so that the largest value is finite
};

/// Finds a point of largest objective by the dual simplex method. It starts at the corner
/// of the box that the objective prefers and adds the most violated inequality until none
/// is violated. O(rows) for each step, of which there are usually about ten. The result
/// is the same on every run.
///
/// The inequalities hold to 1e-12 of the largest limit.
/// \return nothing if the inequalities contradict each other.
std::optional<Eigen::VectorXd> linear_maximum(const LinearMaximum& problem);

}  // namespace endmill
