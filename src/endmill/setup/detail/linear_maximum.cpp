// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/linear_maximum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>

// The dual simplex method:
// 1. The basis holds as many inequalities as there are unknowns. They are met with
//    equality at the current point. The objective is a combination of their rows with
//    weights that are not negative, so that the point is optimal for them.
// 2. The most violated inequality enters the basis. Its row is a combination of the rows
//    of the basis. The row leaves whose weight falls to zero first; the objective then
//    keeps weights that are not negative.
// 3. If no row can leave, the inequalities contradict each other.
// After many steps the lowest numbers decide, which excludes cycles (Bland's rule).

namespace endmill {
namespace {

constexpr double violation_share = 1e-12;  // of the largest limit
constexpr double least_share = 1e-11;      // of a row in the entering row, above rounding
constexpr int steps_before_lowest = 300;
constexpr int most_steps = 20'000;

class DualSimplex {
public:
    explicit DualSimplex(const LinearMaximum& problem)
        : problem_{problem},
          unknowns_{problem.objective.size()},
          basis_(static_cast<std::size_t>(unknowns_)),
          allowed_{violation_share *
                   (problem.limits.size() > 0
                        ? std::max(1.0, problem.limits.cwiseAbs().maxCoeff())
                        : 1.0)}
    {
        for (Eigen::Index k = 0; k < unknowns_; ++k)
            basis_[static_cast<std::size_t>(k)] =
                problem.rows.rows() + 2 * k + (problem.objective[k] < 0 ? 1 : 0);
    }

    std::optional<Eigen::VectorXd> run()
    {
        for (int step = 0; step < most_steps; ++step) {
            const Eigen::PartialPivLU<Eigen::MatrixXd> rows{basis_rows()};
            const Eigen::VectorXd at = rows.solve(basis_limits());
            const Eigen::Index entering = violated(at, step >= steps_before_lowest);
            if (entering < 0)
                return at;
            if (!replace(rows, entering))
                return std::nullopt;
        }
        return std::nullopt;
    }

private:
    // Inequalities are numbered: first the rows of the problem, then x_0 <= box, -x_0 <=
    // box, x_1 <= box and so on.
    Eigen::RowVectorXd row(Eigen::Index number) const
    {
        if (number < problem_.rows.rows())
            return problem_.rows.row(number);
        const Eigen::Index side = number - problem_.rows.rows();
        Eigen::RowVectorXd unit = Eigen::RowVectorXd::Zero(unknowns_);
        unit[side / 2] = side % 2 == 0 ? 1 : -1;
        return unit;
    }

    double limit(Eigen::Index number) const
    {
        return number < problem_.rows.rows() ? problem_.limits[number] : problem_.box;
    }

    Eigen::MatrixXd basis_rows() const
    {
        Eigen::MatrixXd rows{unknowns_, unknowns_};
        for (Eigen::Index k = 0; k < unknowns_; ++k)
            rows.row(k) = row(basis_[static_cast<std::size_t>(k)]);
        return rows;
    }

    Eigen::VectorXd basis_limits() const
    {
        Eigen::VectorXd limits{unknowns_};
        for (Eigen::Index k = 0; k < unknowns_; ++k)
            limits[k] = limit(basis_[static_cast<std::size_t>(k)]);
        return limits;
    }

    // The number of the most violated inequality, or of the first one; -1 if none is.
    Eigen::Index violated(const Eigen::VectorXd& at, bool takes_first) const
    {
        Eigen::Index worst = -1;
        double excess = allowed_;
        const Eigen::VectorXd values = problem_.rows * at - problem_.limits;
        const Eigen::Index all = problem_.rows.rows() + 2 * unknowns_;
        for (Eigen::Index number = 0; number < all; ++number) {
            const double value = number < values.size()
                                     ? values[number]
                                     : row(number).dot(at) - problem_.box;
            if (value <= excess || std::ranges::find(basis_, number) != basis_.end())
                continue;
            worst = number;
            excess = value;
            if (takes_first)
                break;
        }
        return worst;
    }

    // Puts an inequality into the basis. False if none can leave.
    bool replace(const Eigen::PartialPivLU<Eigen::MatrixXd>& rows, Eigen::Index entering)
    {
        const Eigen::VectorXd weights = rows.transpose().solve(problem_.objective);
        const Eigen::VectorXd shares = rows.transpose().solve(row(entering).transpose());
        double least = std::numeric_limits<double>::infinity();
        std::size_t leaving = basis_.size();
        for (std::size_t k = 0; k < basis_.size(); ++k) {
            const double share = shares[static_cast<Eigen::Index>(k)];
            if (share <= least_share)
                continue;
            const double ratio =
                std::max(0.0, weights[static_cast<Eigen::Index>(k)]) / share;
            if (ratio < least || (ratio == least && basis_[k] < basis_[leaving])) {
                least = ratio;
                leaving = k;
            }
        }
        if (leaving == basis_.size())
            return false;
        basis_[leaving] = entering;
        return true;
    }

    const LinearMaximum& problem_;
    Eigen::Index unknowns_;
    std::vector<Eigen::Index> basis_;
    double allowed_;
};

}  // namespace

std::optional<Eigen::VectorXd> linear_maximum(const LinearMaximum& problem)
{
    return DualSimplex{problem}.run();
}

}  // namespace endmill
