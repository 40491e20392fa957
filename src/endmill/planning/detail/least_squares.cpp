// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/least_squares.h"

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>

namespace endmill {
namespace {

constexpr double difference_share = 1e-6;  // of a range
constexpr double least_squares_sum = 1e-12;
constexpr double least_step = 1e-9;  // of a range
constexpr double first_damping = 1e-2;
constexpr double most_damping = 1e10;
constexpr double damping_factor = 5;

// Derivatives by the values as shares of their ranges; nothing if the residuals do not exist
// on either side.
std::optional<Eigen::MatrixXd> jacobian(std::span<const Interval> ranges,
                                        const Residuals& residuals,
                                        const std::vector<double>& values,
                                        const Eigen::VectorXd& here, int& evaluations)
{
    Eigen::MatrixXd derivatives(here.size(), static_cast<Eigen::Index>(values.size()));
    std::vector<double> moved = values;
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::optional<Eigen::VectorXd> there;
        double step = difference_share;
        for (const double sign : {1.0, -1.0}) {
            step = sign * difference_share;
            moved[k] = values[k] + step * ranges[k].length();
            if (moved[k] < ranges[k].low || moved[k] > ranges[k].high)
                continue;
            ++evaluations;
            there = residuals(moved);
            if (there)
                break;
        }
        if (!there)
            return std::nullopt;
        derivatives.col(static_cast<Eigen::Index>(k)) = (*there - here) / step;
        moved[k] = values[k];
    }
    return derivatives;
}

}  // namespace

LeastSquares least_squares(std::span<const Interval> ranges, const Residuals& residuals,
                           std::vector<double> start, int iterations)
{
    LeastSquares best{std::move(start), std::numeric_limits<double>::infinity(), 1};
    std::optional<Eigen::VectorXd> here = residuals(best.values);
    if (!here)
        return best;
    best.squares = here->squaredNorm();
    double damping = first_damping;
    for (int i = 0; i < iterations && best.squares > least_squares_sum; ++i) {
        const auto derivatives =
            jacobian(ranges, residuals, best.values, *here, best.evaluations);
        if (!derivatives)
            return best;
        const Eigen::MatrixXd normal = derivatives->transpose() * *derivatives;
        const Eigen::VectorXd gradient = derivatives->transpose() * *here;
        bool is_better = false;
        while (!is_better && damping < most_damping) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += damping * normal.diagonal();
            damped.diagonal().array() += 1e-12;
            const Eigen::VectorXd step = -damped.ldlt().solve(gradient);
            std::vector<double> trial = best.values;
            double longest = 0;
            for (std::size_t k = 0; k < trial.size(); ++k) {
                const double share = step[static_cast<Eigen::Index>(k)];
                trial[k] = std::clamp(trial[k] + share * ranges[k].length(),
                                      ranges[k].low, ranges[k].high);
                longest = std::max(longest, std::abs(share));
            }
            if (!(longest > least_step))
                return best;
            ++best.evaluations;
            const auto there = residuals(trial);
            is_better = there && there->squaredNorm() < best.squares;
            if (is_better) {
                best.values = std::move(trial);
                best.squares = there->squaredNorm();
                here = there;
                damping /= damping_factor;
            } else {
                damping *= damping_factor;
            }
        }
        if (!is_better)
            return best;
    }
    return best;
}

}  // namespace endmill
