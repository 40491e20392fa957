// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/least_squares.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>

namespace endmill {
namespace {

constexpr double difference_share = 1e-6;  // of a range
constexpr double least_squares_sum = 1e-12;
constexpr double least_step = 1e-9;  // of a range
constexpr double first_damping = 1e-2;
constexpr double most_damping = 1e10;
constexpr double damping_factor = 5;
// Added to the normal matrix: a value without effect must not make it singular.
constexpr double least_diagonal = 1e-12;

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

// A search that keeps the residuals at its best values.
class DampedSearch {
public:
    DampedSearch(std::span<const Interval> ranges, const Residuals& residuals,
                 std::vector<double> start)
        : ranges_{ranges},
          residuals_{residuals},
          best_{std::move(start), std::numeric_limits<double>::infinity(), 1},
          here_{residuals(best_.values)}
    {
        if (here_)
            best_.squares = here_->squaredNorm();
    }

    const LeastSquares& best() const { return best_; }

    // One step that lowers the squares; false if none was found.
    bool improve()
    {
        if (!here_ || best_.squares <= least_squares_sum)
            return false;
        const auto derivatives =
            jacobian(ranges_, residuals_, best_.values, *here_, best_.evaluations);
        if (!derivatives)
            return false;
        const Eigen::MatrixXd normal = derivatives->transpose() * *derivatives;
        const Eigen::VectorXd gradient = derivatives->transpose() * *here_;
        for (; damping_ < most_damping; damping_ *= damping_factor) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += damping_ * normal.diagonal();
            damped.diagonal().array() += least_diagonal;
            const Eigen::VectorXd step = -damped.ldlt().solve(gradient);
            if (!(step.cwiseAbs().maxCoeff() > least_step))
                return false;
            if (accepts(moved(step))) {
                damping_ /= damping_factor;
                return true;
            }
        }
        return false;
    }

private:
    // The best values moved by shares of the ranges, within the ranges.
    std::vector<double> moved(const Eigen::VectorXd& step) const
    {
        std::vector<double> trial = best_.values;
        for (std::size_t k = 0; k < trial.size(); ++k)
            trial[k] = std::clamp(
                trial[k] + step[static_cast<Eigen::Index>(k)] * ranges_[k].length(),
                ranges_[k].low, ranges_[k].high);
        return trial;
    }

    bool accepts(std::vector<double> trial)
    {
        ++best_.evaluations;
        std::optional<Eigen::VectorXd> there = residuals_(trial);
        if (!there || there->squaredNorm() >= best_.squares)
            return false;
        best_.squares = there->squaredNorm();
        best_.values = std::move(trial);
        here_ = std::move(there);
        return true;
    }

    std::span<const Interval> ranges_;
    const Residuals& residuals_;
    LeastSquares best_;
    std::optional<Eigen::VectorXd> here_;
    double damping_ = first_damping;
};

}  // namespace

LeastSquares least_squares(std::span<const Interval> ranges, const Residuals& residuals,
                           std::vector<double> start, int iterations)
{
    DampedSearch search{ranges, residuals, std::move(start)};
    for (int i = 0; i < iterations && search.improve(); ++i) {
    }
    return search.best();
}

}  // namespace endmill
